//! The machine with statig: a handler for each state, whose code is also its entry action.

use statig::prelude::*;

use super::{B_US, D_US, input, work};
use crate::subject::Subject;

#[derive(Default)]
struct Ring {
    entered: u64,
    number: u64,
}

struct Tick {
    now: u64,
}

#[state_machine(initial = "State::a()")]
impl Ring {
    #[state(entry_action = "work_a")]
    fn a(&mut self, event: &Tick) -> Outcome<State> {
        if input(event.now).is_multiple_of(7) {
            return self.to(State::b(), event);
        }
        self.work_a();
        Handled
    }

    #[state(entry_action = "work_b")]
    fn b(&mut self, event: &Tick) -> Outcome<State> {
        if event.now - self.entered >= B_US {
            return self.to(State::c(), event);
        }
        self.work_b();
        Handled
    }

    #[state(entry_action = "work_c")]
    fn c(&mut self, event: &Tick) -> Outcome<State> {
        if input(event.now).is_multiple_of(5) {
            return self.to(State::d(), event);
        }
        self.work_c();
        Handled
    }

    #[state(entry_action = "work_d")]
    fn d(&mut self, event: &Tick) -> Outcome<State> {
        if event.now - self.entered >= D_US {
            return self.to(State::e(), event);
        }
        self.work_d();
        Handled
    }

    #[state(entry_action = "work_e")]
    fn e(&mut self, event: &Tick) -> Outcome<State> {
        if input(event.now).is_multiple_of(3) {
            return self.to(State::a(), event);
        }
        self.work_e();
        Handled
    }

    #[action]
    fn work_a(&mut self) {
        self.number = work::<0>(self.number);
    }

    #[action]
    fn work_b(&mut self) {
        self.number = work::<1>(self.number);
    }

    #[action]
    fn work_c(&mut self) {
        self.number = work::<2>(self.number);
    }

    #[action]
    fn work_d(&mut self) {
        self.number = work::<3>(self.number);
    }

    #[action]
    fn work_e(&mut self) {
        self.number = work::<4>(self.number);
    }
}

impl Ring {
    fn to(&mut self, state: State, event: &Tick) -> Outcome<State> {
        self.entered = event.now;
        Transition(state)
    }
}

/// The machine with statig.
pub struct Statig(InitializedStateMachine<Ring>);

impl Statig {
    /// Creates the machine.
    #[must_use]
    pub fn new() -> Self {
        // The entry action of the first state runs here; it changes the number from 0 to 1.
        Self(Ring::default().uninitialized_state_machine().init())
    }
}

impl Default for Statig {
    fn default() -> Self {
        Self::new()
    }
}

impl Subject for Statig {
    fn cycle(&mut self, now: u64) {
        self.0.handle(&Tick { now });
    }

    fn result(&self) -> u64 {
        self.0.inner().number
    }
}
