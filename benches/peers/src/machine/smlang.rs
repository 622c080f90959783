//! The machine with smlang: a table of transitions, whose guards and actions are functions of a context.

use smlang::statemachine;

use super::{B_US, D_US, input, work};
use crate::subject::Subject;

/// The event of a step.
#[expect(unreachable_pub, reason = "the types that smlang writes name it, and they are public")]
#[derive(Clone, Copy)]
pub struct Step {
    now: u64,
}

statemachine! {
    transitions: {
        *A + Tick(Step) [a_is_over] / enter_b = B,
        A + Tick(Step) / work_a,
        B + Tick(Step) [b_is_over] / enter_c = C,
        B + Tick(Step) / work_b,
        C + Tick(Step) [c_is_over] / enter_d = D,
        C + Tick(Step) / work_c,
        D + Tick(Step) [d_is_over] / enter_e = E,
        D + Tick(Step) / work_d,
        E + Tick(Step) [e_is_over] / enter_a = A,
        E + Tick(Step) / work_e,
    }
}

/// What all states share.
#[expect(unreachable_pub, reason = "the types that smlang writes name it, and they are public")]
pub struct Context {
    entered: u64,
    number: u64,
}

/// The code of one state: in it, and on the way into it.
macro_rules! state {
    ($work:ident, $enter:ident, $place:literal) => {
        fn $work(&mut self, _: Step) -> Result<(), ()> {
            self.number = work::<$place>(self.number);
            Ok(())
        }

        fn $enter(&mut self, step: Step) -> Result<(), ()> {
            self.entered = step.now;
            self.$work(step)
        }
    };
}

impl StateMachineContext for Context {
    state!(work_a, enter_a, 0);
    state!(work_b, enter_b, 1);
    state!(work_c, enter_c, 2);
    state!(work_d, enter_d, 3);
    state!(work_e, enter_e, 4);

    fn a_is_over(&self, step: &Step) -> Result<bool, ()> {
        Ok(input(step.now).is_multiple_of(7))
    }

    fn b_is_over(&self, step: &Step) -> Result<bool, ()> {
        Ok(step.now - self.entered >= B_US)
    }

    fn c_is_over(&self, step: &Step) -> Result<bool, ()> {
        Ok(input(step.now).is_multiple_of(5))
    }

    fn d_is_over(&self, step: &Step) -> Result<bool, ()> {
        Ok(step.now - self.entered >= D_US)
    }

    fn e_is_over(&self, step: &Step) -> Result<bool, ()> {
        Ok(input(step.now).is_multiple_of(3))
    }
}

/// The machine with smlang.
pub struct Smlang(StateMachine<Context>);

impl Smlang {
    /// At rest.
    #[must_use]
    pub const fn new() -> Self {
        Self(StateMachine::new(Context { entered: 0, number: 1 }))
    }
}

impl Default for Smlang {
    fn default() -> Self {
        Self::new()
    }
}

impl Subject for Smlang {
    fn cycle(&mut self, now: u64) {
        // No step is refused: every state has a transition without a guard.
        _ = self.0.process_event(Events::Tick(Step { now }));
    }

    fn result(&self) -> u64 {
        self.0.context().number
    }
}
