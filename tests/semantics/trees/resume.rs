//! Two machines that become latent together: one resumes its state, the other starts in its initial state.

use bica::prelude::*;

use crate::support::rig::rig;
use crate::support::unit::unit;

unit!(Switch() {
    #[state(initial)]
    fn on(&mut self, time: &Time, keeps: &mut Keeps, forgets: &mut Forgets) {
        self.unit.body("on", time, [], [&mut keeps.unit, &mut forgets.unit]);
    }

    #[state]
    fn off(&mut self, time: &Time) {
        self.unit.body("off", time, [], []);
    }

    #[transition(on -> off)]
    fn put_off(&self) -> bool {
        self.unit.asked("put_off", [])
    }

    #[transition(off -> on)]
    fn put_on(&self) -> bool {
        self.unit.asked("put_on", [])
    }
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
                self.unit.asked("begin", [])
            }

            #[transition(second -> third, after_ms = 300)]
            fn timer_second(&self) -> bool {
                true
            }

            #[transition(third -> first)]
            fn again(&self) -> bool {
                self.unit.asked("again", [])
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

walker!(Keeps(resume, hz = 40) on KeepsLeaf);
walker!(Forgets(hz = 40) on ForgetsLeaf);

activation_tree! {
    /// One remembers.
    pub(crate) struct Resume {
        root: Switch,
        cycle_hz: 100,
        components: [Switch, Keeps, KeepsLeaf, Forgets, ForgetsLeaf],
    }
}

rig!(
    Resume: [Switch, Keeps, KeepsLeaf, Forgets, ForgetsLeaf],
    entry: [
        Keeps.first: enter_first, Keeps.second: enter, Keeps.third: enter,
        Forgets.first: enter_first, Forgets.second: enter, Forgets.third: enter
    ]
);
