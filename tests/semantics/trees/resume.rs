//! Two state machines that become latent together: one resumes its state, the other starts again in its initial state.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::unit;

unit!(Switch() {
    #[state(initial)]
    fn on(&mut self, time: &Time, resuming: &mut Resuming, restarting: &mut Restarting) {
        self.unit.body("on", time, [], [&mut resuming.unit, &mut restarting.unit]);
    }

    #[state]
    fn off(&mut self, time: &Time) {
        self.unit.body("off", time, [], []);
    }
} when {
    put_off(on -> off);
    put_on(off -> on);
});

macro_rules! walker {
    ($name:ident($($attributes:tt)*) on $leaf:ident) => {
        unit!($name($($attributes)*) {
            #[state]
            fn second(&mut self, time: &Time, leaf: &mut $leaf) {
                self.unit.body("second", time, [], [&mut leaf.unit]);
            }

            #[state(initial)]
            fn first(&mut self, time: &Time) {
                self.unit.body("first", time, [], []);
            }

            #[state]
            fn third(&mut self, time: &Time, leaf: &$leaf) {
                self.unit.body("third", time, [leaf.unit.read()], []);
            }

            #[transition(first -> second)]
            fn begin(&self) -> bool {
                self.unit.evaluate("begin", [])
            }

            #[transition(second -> third, after_ms = 300)]
            fn timer_second(&self) -> bool {
                true
            }

            #[transition(third -> first)]
            fn again(&self) -> bool {
                self.unit.evaluate("again", [])
            }

            #[entry(first)]
            fn enter_first(&mut self) {
                self.unit.hook("enter_first", [], []);
            }

            #[entry(second | third)]
            fn enter(&mut self) {
                self.unit.hook("enter", [], []);
            }
        });

        unit!($leaf(hz = 20) {
            fn step(&mut self, time: &Time) {
                self.unit.body("", time, [], []);
            }
        });
    };
}

walker!(Resuming(resume, hz = 40) on ResumingLeaf);
walker!(Restarting(hz = 40) on RestartingLeaf);

activation_tree! {
    /// One machine resumes its state, the other one restarts.
    pub(crate) struct Resume {
        root: Switch,
        cycle_hz: 100,
        components: [Switch, Resuming, ResumingLeaf, Restarting, RestartingLeaf],
    }
}

test_tree!(
    Resume: [Switch, Resuming, ResumingLeaf, Restarting, RestartingLeaf],
    entry: [
        Resuming.first: enter_first, Resuming.second: enter, Resuming.third: enter,
        Restarting.first: enter_first, Restarting.second: enter, Restarting.third: enter
    ]
);
