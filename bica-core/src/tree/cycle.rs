//! One cycle of a tree: what is visited, what is due, what starts and what stops.

use embassy_time::Instant;

use super::cycle_state::VisitOutcome;
use super::engine;
use super::layout::borrow::{BorrowSet, Write};
use super::layout::{Cycle, Has, Layout, Machine, MemberOf, Visit, WorkOf};
use super::member::{id, is_aged, is_root, policy, tolerance};
use super::results;
use crate::age::Age;
use crate::component::{Component, Time};
use crate::probe::Probe;
use crate::work::WorkSlot;

impl<T: Layout, P> Drop for Cycle<'_, T, P> {
    fn drop(&mut self) {
        if cfg!(panic = "unwind") {
            engine::interrupt(self);
        }
    }
}

impl<'t, T: Layout, P: Probe> Cycle<'t, T, P> {
    /// Whether a visit of `C` is known to end here: it was visited in this cycle. If it is given a rate that it does not
    /// declare, only the visit itself finds that out.
    #[inline]
    #[must_use]
    pub fn was_visited<C: 'static>(&self) -> bool
    where
        T: Has<C>,
    {
        self.store.component_state::<C>().activation().is_visited_as_before(self.store.cycle_state().parity())
    }

    /// Returns whether a run of `C` is due, and if so moves its grid on.
    #[inline]
    #[must_use]
    pub fn is_due<C: 'static>(&self) -> bool
    where
        T: Has<C>,
    {
        let (state, now) = (self.store.component_state::<C>(), self.now().as_ticks());
        state.is_due(now, self.store.period::<C>(), const { tolerance::<T, C>() })
    }

    /// Begins the visit of `C` if it was active before, and nothing is to be asked but whether it is due; returns whether that was so.
    #[inline]
    #[must_use]
    pub fn visits_as_before<C: 'static>(&mut self) -> bool
    where
        T: Has<C>,
    {
        let previous = self.store.cycle_state().previous();
        self.store.component_state::<C>().activation().visits_as_before(previous)
    }

    /// Begins the visit of `C` in all cases; it starts if it was latent.
    #[inline]
    #[must_use]
    pub fn visit_any<C: 'static>(&mut self) -> VisitOutcome
    where
        T: Has<C>,
    {
        let cycle_state = self.store.cycle_state();
        // An unwound tick leaves no component awaited, so the next tick begins with this visit of the root.
        if cfg!(panic = "unwind") && const { is_root::<T, C>() } && cycle_state.is_interrupted() {
            engine::stop_interrupted(self);
        }
        let state = self.store.component_state::<C>();
        let begins_anew = const { results::has_ends(<T::Member as Component>::STATES) } && state.begins_anew();
        let mut outcome = cycle_state.visit(state, self.store.period::<C>(), const { &policy::<T, C>() });
        if begins_anew && !outcome.is_closed() {
            outcome = self.begin_anew::<C>(outcome);
        }
        if outcome.is_started() {
            self.probe.start(id::<T, C>());
            T::Member::start(self);
        }
        outcome
    }

    /// Whether `C`, which declares no rate and is visited, was given one. Then the next visit reads its period too.
    #[inline]
    #[must_use]
    pub fn is_given_rate<C: 'static>(&self) -> bool
    where
        T: Has<C>,
    {
        let is_given = !self.store.period::<C>().is_every_cycle();
        if is_given {
            self.store.component_state::<C>().activation().read_period();
        }
        is_given
    }

    /// `C` is visited and not due.
    #[inline]
    pub fn skip<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.probe.skip(id::<T, C>());
    }

    /// Makes `C` latent.
    #[inline]
    pub fn stop<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        // First, because a hook may unwind.
        self.work::<C>().cancel();
        T::Member::stop(self);
        self.probe.stop(id::<T, C>());
    }

    /// Borrows `C` mutably, and the components of `L`.
    #[inline]
    pub fn borrow<C: 'static, L: BorrowSet<T>>(&mut self) -> (&mut C, L::Borrowed<'_>)
    where
        T: Has<C>,
    {
        self.store.borrow::<(Write<C>, L)>()
    }

    /// The place of the jobs of `C`.
    #[inline]
    #[must_use]
    pub fn work<C: 'static>(&self) -> &'t WorkOf<T, C>
    where
        T: Has<C>,
    {
        T::slot(self.store.slots()).work()
    }

    /// The run of `C` begins, and with it its own code.
    #[inline]
    pub fn begin_run<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.probe.run(id::<T, C>());
        self.begin_code::<C>();
    }

    #[inline]
    fn begin_code<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.probe.begin(id::<T, C>());
    }

    /// The own code of the state machine `C` begins, or continues in a new state.
    #[inline]
    pub fn begin_state<C: 'static>(&mut self, machine: Machine)
    where
        T: Has<C>,
    {
        if machine.moved {
            self.begin_code::<C>();
        } else {
            self.begin_run::<C>();
        }
    }

    #[inline]
    fn end_code<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.probe.end(id::<T, C>());
    }

    /// The run of `C` ends, and with it its own code. What it modulates is visited after that and finds that it has run.
    #[inline]
    pub fn end_run<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        if T::Member::TIMED || const { is_aged::<T, C>() } {
            self.store.component_state::<C>().record_run(self.now());
        }
        self.end_code::<C>();
    }

    #[inline]
    fn now(&self) -> Instant {
        self.store.cycle_state().now()
    }

    /// Returns the times of `C`.
    #[inline]
    #[must_use]
    pub fn time<C: 'static>(&self) -> Time
    where
        T: Has<C>,
    {
        let (state, now) = (self.store.component_state::<C>(), self.now());
        Time { now, since_run: state.since_run(now), in_state: state.in_state(now) }
    }

    /// Returns the age of `C`.
    #[inline]
    #[must_use]
    pub fn age<C: 'static>(&self) -> Age<C>
    where
        T: Has<C>,
    {
        let state = self.store.component_state::<C>();
        Age::new(state.since().is_some().then(|| state.since_run(self.now())))
    }

    /// Returns the state of the state machine `C` as its visit begins.
    #[inline]
    #[must_use]
    pub fn machine<C: 'static>(&self, visit: Visit) -> Machine
    where
        T: Has<C>,
    {
        Machine { state: self.store.component_state::<C>().state_index(), entering: visit.entering, moved: false }
    }

    /// Whether the state machine `C` has been in its state for at least `ms` milliseconds.
    #[inline]
    #[must_use]
    pub fn has_been_in_state<C: 'static>(&self, ms: u32) -> bool
    where
        T: Has<C>,
    {
        self.store.component_state::<C>().has_been_in_state(ms, self.now())
    }

    /// The condition of a transition of the state machine `C` was evaluated. Returns whether it holds.
    #[inline]
    pub fn condition<C: 'static>(&mut self, transition: usize, holds: bool) -> bool
    where
        T: Has<C>,
    {
        self.probe.condition(id::<T, C>(), transition, holds);
        holds
    }

    /// The state machine `C` enters another state; its own code pauses until the children of that state were visited.
    pub fn transition<C: 'static>(&mut self, from: usize, to: usize) -> Machine
    where
        T: Has<C>,
    {
        if const { <T::Member as MemberOf<T>>::HAS_CHILDREN } {
            self.store.cycle_state().request_recheck();
            if const { T::PLANS.exist() && is_root::<T, C>() } {
                self.store.cycle_state().set_steady(false);
            }
        }
        self.store.component_state::<C>().enter(to, self.now());
        self.end_code::<C>();
        self.probe.transition(id::<T, C>(), from, to);
        Machine { state: to, entering: true, moved: true }
    }
}
