//! Work beside the loop: jobs that take longer than a cycle.
//!
//! `#[work(takes_ms = 200)]` declares a function of a component that runs beside the loop; the component begins a job with its argument
//! [`Work<Self>`](Work), and finds the result there in a later run. A job owns its inputs, sees nothing of the tree, and its result is a
//! function of them. So only the cycle in which the result arrives can differ:
//!
//! - **By itself a tree is in simulated time**: [`tick`](crate::Tree::tick) runs a job in the first cycle at or after its due time, which
//!   is `takes_ms` after the cycle in which it was begun. The result is there in that cycle, whatever the computer needed.
//! - **A runner may take jobs away** with [`WorkSlot::take`] and put the results back with [`WorkSlot::put`], between two cycles. The
//!   result is there in the first cycle after that, early or late. So a runner with threads can wait for the due time, which is
//!   simulated time with less waiting, or not wait, which is real time; a replay puts each result back before the recorded cycle.
//! - On a microcontroller, [`WorkSlot::slice`] runs a part of a job in the idle time between two cycles.

use core::cell::{RefCell, RefMut};

use embassy_time::Instant;

use crate::id::ComponentId;
pub use crate::tree::WorkOf;
use crate::tree::{Has, Member, Tree};

mod cycle;
mod job;
mod slot;

pub(crate) use cycle::{cycle, drop_all};
pub use job::Jobs;
use job::Phase;
pub use slot::{JobEnd, Taken, WorkSlot};

/// The jobs of component `C`, one at a time: an argument `work: &mut Work<Self>` of its step, states and hooks.
///
/// `begin` takes the arguments of the function with `#[work]`; that of a function with `#[work(slices)]` takes the state. It begins a job.
/// A job in progress, or a result that nobody took, is dropped.
///
/// If the component becomes latent, its job or the result is dropped, too. A job that panics has no result: then
/// [`is_idle`](Self::is_idle) returns true, and [`result`](Self::result) nothing.
pub struct Work<C: Working>(C::Begin);

impl<C: Working> Work<C> {
    /// Takes the result of the job; `None` if there is no job, it is in progress, or its result was taken.
    pub fn result(&mut self) -> Option<C::Output> {
        let phase = &mut self.jobs().phase;
        if !matches!(phase, Phase::Ready(_)) {
            return None;
        }
        if let Phase::Ready(output) = core::mem::replace(phase, Phase::Idle) { Some(output) } else { None }
    }

    /// Whether there is neither a job in progress nor a result to take.
    #[must_use]
    pub fn is_idle(&self) -> bool {
        matches!(self.0.as_ref().phase, Phase::Idle)
    }

    fn jobs(&mut self) -> &mut Jobs<C> {
        self.0.as_mut()
    }
}

impl<C: Working> core::ops::Deref for Work<C> {
    type Target = C::Begin;

    fn deref(&self) -> &C::Begin {
        &self.0
    }
}

impl<C: Working> core::ops::DerefMut for Work<C> {
    fn deref_mut(&mut self) -> &mut C::Begin {
        &mut self.0
    }
}

/// A component with a function that runs beside the loop; `#[work]` implements it.
pub trait Working: Sized + 'static {
    /// What a job owns: the arguments, or the state of one in slices.
    type State: Send + 'static;
    /// The result.
    type Output: Send + 'static;
    /// The jobs, with the function `begin`.
    #[doc(hidden)]
    type Begin: AsRef<Jobs<Self>> + AsMut<Jobs<Self>>;
    /// Empty jobs.
    #[doc(hidden)]
    const BEGIN: Self::Begin;
    /// Declared time of a job, ms.
    const TAKES_MS: u32;

    /// Runs a part of a job; returns the result with the last part, and is not called again after that.
    fn slice(state: &mut Self::State) -> Option<Self::Output>;
}

/// Runs a job to its end.
pub fn finish<C: Working>(mut state: C::State) -> C::Output {
    loop {
        if let Some(output) = C::slice(&mut state) {
            return output;
        }
    }
}

/// The place of the jobs of a component with work.
#[doc(hidden)]
pub struct WorkCell<C: Working>(RefCell<Work<C>>);

impl<C: Working> WorkCell<C> {
    /// Borrows the jobs for a call of the component.
    pub fn borrow(&self) -> RefMut<'_, Work<C>> {
        self.0.borrow_mut()
    }
}

impl<C: Working> WorkSlot for WorkCell<C> {
    type State = C::State;
    type Output = C::Output;
    const EMPTY: Self = Self(RefCell::new(Work(C::BEGIN)));

    fn take(&self) -> Option<Taken<C::State>> {
        self.borrow().jobs().take()
    }

    fn finish(state: C::State) -> C::Output {
        finish::<C>(state)
    }

    fn put(&self, ticket: u32, output: Option<C::Output>) {
        self.borrow().jobs().put(ticket, output);
    }

    fn claim(&self) {
        self.borrow().jobs().claim();
    }

    fn slice(&self) -> bool {
        self.borrow().jobs().slice()
    }

    fn is_awaited(&self, ticket: u32) -> bool {
        let mut work = self.borrow();
        let jobs = work.jobs();
        jobs.ticket == ticket && matches!(jobs.phase, Phase::Away(_))
    }

    fn cancel(&self) {
        self.borrow().jobs().cancel();
    }

    fn settle(&self, now: Instant) -> Option<Instant> {
        self.borrow().jobs().settle(now)
    }

    fn deliver(&self, now: Instant) -> Option<JobEnd> {
        self.borrow().jobs().deliver(now)
    }
}

/// Returns the place of the jobs of component `C`.
pub fn slot<T: Tree + Has<C>, C: 'static>(tree: &T) -> &WorkOf<T, C> {
    T::slot(tree.engine().store.slots()).work()
}

/// What a runner does with the jobs of each component.
pub trait Visitor<T: Tree> {
    /// Called with the place of the jobs of component `C`.
    fn visit<C: 'static>(&mut self, component: ComponentId, slot: &WorkOf<T, C>)
    where
        T: Has<C>;
}

/// Calls `visitor` with each component of a tree that has work, in the order of the tree's list.
pub fn visit<T: Tree>(tree: &T, visitor: &mut impl Visitor<T>) {
    if T::WORKS {
        let with_work = (0..T::COUNT).filter(|&index| T::GRAPH.nodes[index].work.is_some());
        with_work.for_each(|index| visit_at(tree, ComponentId::new(index), visitor));
    }
}

/// Calls `visitor` with one component.
pub fn visit_at<T: Tree>(tree: &T, component: ComponentId, visitor: &mut impl Visitor<T>) {
    struct At<'a, T, V>(&'a T, &'a mut V);

    impl<T: Tree, V: Visitor<T>> Member<T> for At<'_, T, V> {
        type Output = ();

        fn visit<C: 'static>(self)
        where
            T: Has<C>,
        {
            self.1.visit::<C>(const { ComponentId::new(T::INDEX) }, slot::<T, C>(self.0));
        }
    }

    T::member(component.index(), At(tree, visitor));
}
