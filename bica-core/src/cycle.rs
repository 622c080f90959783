//! One cycle of a tree: who is visited, who is due, who begins and who ends.

use embassy_time::{Duration, Instant};

use crate::component::{Component, Time};
use crate::id::ComponentId;
use crate::loan::{Key, Loan, Pace, Write};
use crate::probe::Probe;
use crate::set::Set;
use crate::tree::{Has, Layout, Wired};

/// A cycle of tree `T` that is going on, watched by `P`.
pub struct Cycle<'t, T: Layout, P> {
    pub(crate) key: Key<'t, T>,
    pub(crate) now: Instant,
    /// Active in the cycle before.
    pub(crate) before: T::Set,
    /// Visited in this cycle, or not to be visited at all. Numbered by rank, as all sets here.
    pub(crate) closed: T::Set,
    pub(crate) probe: &'t mut P,
}

/// What a visit finds.
#[derive(Clone, Copy)]
pub struct Turn {
    /// The component is to run.
    pub due: bool,
    /// A state machine begins in its initial state.
    pub entering: bool,
}

/// Where a state machine is in its run.
#[derive(Clone, Copy)]
pub struct Machine {
    /// Index of the state.
    pub state: usize,
    /// The state's entry hooks are still to be called.
    pub entering: bool,
    /// A transition was taken in this run.
    pub moved: bool,
}

impl<T: Layout, P: Probe> Cycle<'_, T, P> {
    /// Visits `C`, unless it was visited in this cycle or is held latent.
    #[inline]
    pub fn visit<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        if !self.closed.insert(T::RANK) {
            return;
        }
        let turn = self.turn::<C>();
        if !turn.due {
            self.probe.skip(id::<T, C>());
        }
        T::Member::pass(self, turn);
        if T::Member::TIMED && turn.due {
            self.key.clock::<C>().ran(self.now);
        }
    }

    /// What a visit of `C` finds.
    #[inline]
    fn turn<C: 'static>(&mut self) -> Turn
    where
        T: Has<C>,
    {
        if !self.before.contains(T::RANK) {
            return self.start::<C>();
        }
        let clock = self.key.clock::<C>();
        let (rate, ()) = self.key.lend::<(Pace<C>, ())>();
        Turn { due: clock.due(self.now, rate.period()), entering: false }
    }

    /// `C` becomes active.
    fn start<C: 'static>(&mut self) -> Turn
    where
        T: Has<C>,
    {
        let clock = self.key.clock::<C>();
        clock.anchor(self.now);
        let entering = !T::Member::RESUME || clock.state().is_none();
        if entering {
            clock.enter((!T::Member::STATES.is_empty()).then_some(T::Member::INITIAL), self.now);
        }
        self.probe.start(id::<T, C>());
        T::Member::start(self);
        Turn { due: true, entering }
    }

    /// `C` becomes latent.
    #[inline]
    pub fn stop<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        T::Member::stop(self);
        self.probe.stop(id::<T, C>());
    }

    /// Lends `C` to be written, and what else `L` names.
    #[inline]
    pub fn lend<C: 'static, L: Loan<T>>(&mut self) -> (&mut C, L::Lent<'_>)
    where
        T: Has<C>,
    {
        self.key.lend::<(Write<C>, L)>()
    }

    /// `C` runs, and its own code begins.
    #[inline]
    pub fn run<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.probe.run(id::<T, C>());
        self.begin::<C>();
    }

    /// The own code of `C` begins.
    #[inline]
    fn begin<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.probe.begin(id::<T, C>());
    }

    /// The own code of the machine `C` begins, or goes on in a new state.
    #[inline]
    pub fn round<C: 'static>(&mut self, machine: Machine)
    where
        T: Has<C>,
    {
        if machine.moved {
            self.begin::<C>();
        } else {
            self.run::<C>();
        }
    }

    /// The own code of `C` has ended.
    #[inline]
    pub fn end<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.probe.end(id::<T, C>());
    }

    /// The time as `C` sees it.
    #[inline]
    pub fn time<C: 'static>(&self) -> Time
    where
        T: Has<C>,
    {
        let clock = self.key.clock::<C>();
        Time { now: self.now, since_run: clock.since_run(self.now), in_state: clock.in_state(self.now) }
    }

    /// Where the machine `C` stands as it is visited.
    #[inline]
    pub fn machine<C: 'static>(&self, turn: Turn) -> Machine
    where
        T: Has<C>,
    {
        Machine { state: self.key.clock::<C>().place(), entering: turn.entering, moved: false }
    }

    /// Whether the machine `C` has been in its state for that long.
    #[inline]
    pub fn stayed<C: 'static>(&self, ms: u32) -> bool
    where
        T: Has<C>,
    {
        self.key.clock::<C>().in_state(self.now) >= Duration::from_millis(ms as u64)
    }

    /// The machine `C` goes to another state; its own code pauses until the children there have been visited.
    pub fn transit<C: 'static>(&mut self, from: usize, to: usize) -> Machine
    where
        T: Has<C>,
    {
        self.key.clock::<C>().enter(Some(to), self.now);
        self.end::<C>();
        self.probe.transition(id::<T, C>(), from, to);
        Machine { state: to, entering: true, moved: true }
    }
}

#[inline]
fn id<T: Has<C>, C: 'static>() -> ComponentId {
    const { ComponentId::new(T::INDEX) }
}
