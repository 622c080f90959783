//! State machine that exchanges its children; one child is a state machine, too.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::unit;

unit!(Chooser(hz = 50) {
    #[state(initial)]
    fn rest(&mut self, time: &Time) {
        self.unit.body("rest", time, [], []);
    }

    #[state]
    fn left(&mut self, time: &Time, left: &mut Left, both: &Both) {
        self.unit.body("left", time, [both.unit.read()], [&mut left.unit]);
    }

    #[state]
    fn right(&mut self, both: &mut Both, time: &Time, right: &Right) {
        self.unit.body("right", time, [right.unit.read()], [&mut both.unit]);
    }

    #[transition(rest -> left)]
    fn go_left(&self, sensor: &Sensor) -> bool {
        self.unit.evaluate("go_left", [sensor.unit.read()])
    }

    #[transition(rest | left -> right)]
    fn go_right(&self, left: &Left) -> bool {
        self.unit.evaluate("go_right", [left.unit.read()])
    }

    #[transition(right -> left)]
    fn back(&self, both: &Both, sensor: &Sensor) -> bool {
        self.unit.evaluate("back", [both.unit.read(), sensor.unit.read()])
    }
} when {
    stop(* -> rest);
});

unit!(Left() {
    #[state(initial)]
    fn idle(&mut self, time: &Time, sensor: &Sensor) {
        self.unit.body("idle", time, [sensor.unit.read()], []);
    }

    #[state]
    fn busy(&mut self, time: &Time, motor: &mut Motor) {
        self.unit.body("busy", time, [], [&mut motor.unit]);
    }

    #[transition(idle -> busy)]
    fn work(&self, motor: &Motor) -> bool {
        self.unit.evaluate("work", [motor.unit.read()])
    }

    #[transition(busy -> idle)]
    fn pause(&self, motor: &Motor) -> bool {
        self.unit.evaluate("pause", [motor.unit.read()])
    }
});

unit!(Right(hz = 20) {
    fn step(&mut self, time: &Time, motor: &mut Motor) {
        self.unit.body("", time, [], [&mut motor.unit]);
    }
});

unit!(Both(hz = 30) {
    fn step(&mut self, time: &Time, sensor: &Sensor) {
        self.unit.body("", time, [sensor.unit.read()], []);
    }
});

unit!(Motor(writers = first));

unit!(Sensor(hz = 60));

activation_tree! {
    /// Children that become active and latent.
    pub(crate) struct Swap {
        root: Chooser,
        cycle_hz: 100,
        components: [Chooser, Both, Motor, Left, Sensor, Right],
    }
}

test_tree!(Swap: [Chooser, Both, Motor, Left, Sensor, Right]);
