//! One cycle of a tree: who is visited, who is due, who begins and who ends.

use embassy_time::{Duration, Instant};

use crate::clock::Begin;
use crate::component::{Component, Time};
use crate::id::ComponentId;
use crate::loan::{Key, Loan, Pace, Write};
use crate::probe::Probe;
use crate::pulse::Found;
use crate::tree::{Has, Layout, Wired};

/// Where no operating system is, flash is scarce: there the compiler is not asked for code that is faster and larger.
const SMALL: bool = cfg!(target_os = "none");

/// A cycle of tree `T` that is going on, watched by `P`.
pub struct Cycle<'t, T: Layout, P> {
    pub(crate) key: Key<'t, T>,
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
        if T::ACTIVATORS[T::INDEX] < 2 {
            self.enter::<C>();
        } else if !self.key.clock::<C>().mark().was_visited(self.key.pulse().beat()) {
            self.enter_from_anywhere::<C>();
        }
    }

    /// The visit of a component that several activate: one function, whoever calls it.
    #[cfg_attr(not(target_os = "none"), inline(never))]
    fn enter_from_anywhere<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.enter::<C>();
    }

    /// The visit of `C`. Almost always it was active before, and then little is to be asked.
    #[inline]
    fn enter<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        let (pulse, clock) = (self.key.pulse(), self.key.clock::<C>());
        let (beat, mark) = (pulse.beat(), clock.mark());
        let period = self.period::<C>();
        let awaited = mark.is_awaited(pulse.before());
        if <T::Member as Component>::HZ.is_some() || SMALL {
            let found = if awaited {
                mark.visit(beat);
                if clock.due(pulse, period) { Found::DUE } else { Found::WAITING }
            } else {
                self.look::<C>()
            };
            if !found.is_closed() {
                self.pass::<C>(Turn { due: found.is_due(), entering: found.entered() });
            }
            return;
        }
        // The two ways join here, where no component's numbers are at hand yet, so that they can stay in registers.
        let found = if awaited && *period == 0 {
            mark.visit(beat);
            Found::DUE
        } else {
            self.look_or_pause::<C>()
        };
        if !found.is_closed() {
            self.pass::<C>(Turn { due: true, entering: found.entered() });
        }
    }

    #[inline]
    fn period<C: 'static>(&mut self) -> &u64
    where
        T: Has<C>,
    {
        let (rate, ()) = self.key.lend::<(Pace<C>, ())>();
        rate.period()
    }

    /// What a visit finds of a component that declares no rate. One that was given a rate and is not due is visited here,
    /// which closes it.
    #[cold]
    #[inline(never)]
    fn look_or_pause<C: 'static>(&mut self) -> Found
    where
        T: Has<C>,
    {
        let found = self.look::<C>();
        if found.is_due() || found.is_closed() {
            return found;
        }
        self.pass::<C>(Turn { due: false, entering: false });
        Found::CLOSED
    }

    #[inline]
    fn pass<C: 'static>(&mut self, turn: Turn)
    where
        T: Has<C>,
    {
        if !turn.due {
            self.probe.skip(id::<T, C>());
        }
        T::Member::pass(self, turn);
        if T::Member::TIMED && turn.due {
            self.key.clock::<C>().ran(self.now());
        }
    }

    /// What a visit of `C` finds in all cases; it becomes active if it was not.
    #[inline]
    fn look<C: 'static>(&mut self) -> Found
    where
        T: Has<C>,
    {
        let initial = const { if T::Member::STATES.is_empty() { None } else { Some(T::Member::INITIAL) } };
        let begin = Begin::new(initial, T::Member::RESUME);
        let (pulse, clock) = (self.key.pulse(), self.key.clock::<C>());
        let found = pulse.look(clock, self.period::<C>(), begin);
        if found.began() {
            self.probe.start(id::<T, C>());
            T::Member::start(self);
        }
        found
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

    #[inline]
    fn now(&self) -> Instant {
        self.key.pulse().now()
    }

    /// The time as `C` sees it.
    #[inline]
    #[must_use]
    pub fn time<C: 'static>(&self) -> Time
    where
        T: Has<C>,
    {
        let (clock, now) = (self.key.clock::<C>(), self.now());
        Time { now, since_run: clock.since_run(now), in_state: clock.in_state(now) }
    }

    /// Where the machine `C` stands as it is visited.
    #[inline]
    #[must_use]
    pub fn machine<C: 'static>(&self, turn: Turn) -> Machine
    where
        T: Has<C>,
    {
        Machine { state: self.key.clock::<C>().place(), entering: turn.entering, moved: false }
    }

    /// Whether the machine `C` has been in its state for that long.
    #[inline]
    #[must_use]
    pub fn stayed<C: 'static>(&self, ms: u32) -> bool
    where
        T: Has<C>,
    {
        self.key.clock::<C>().in_state(self.now()) >= Duration::from_millis(ms as u64)
    }

    /// The machine `C` goes to another state; its own code pauses until the children there have been visited.
    pub fn transit<C: 'static>(&mut self, from: usize, to: usize) -> Machine
    where
        T: Has<C>,
    {
        self.key.pulse().unsettle();
        self.key.clock::<C>().enter(to, self.now());
        self.end::<C>();
        self.probe.transition(id::<T, C>(), from, to);
        Machine { state: to, entering: true, moved: true }
    }
}

#[inline]
fn id<T: Has<C>, C: 'static>() -> ComponentId {
    const { ComponentId::new(T::INDEX) }
}
