//! State machine with timers, hooks and transitions from several states.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::{aged, unit};

unit!(Owner() {
    fn step(&mut self, time: &Time, clockwork: &mut Clockwork) {
        self.unit.body("", time, [], [&mut clockwork.unit]);
    }
});

unit!(Clockwork(hz = 50) {
    #[state(initial)]
    fn wait(&mut self, time: &Time) {
        self.unit.body("wait", time, [], []);
    }

    #[state]
    fn work(&mut self, time: &Time, sensor: &Sensor, sensed: &Age<Sensor>, motor: &mut Motor) {
        aged("Sensor", sensed);
        self.unit.body("work", time, [sensor.unit.read()], [&mut motor.unit]);
    }

    #[state]
    fn fallen(&mut self, time: &Time, lit: &Age<Lamp>) {
        aged("Lamp", lit);
        self.unit.body("fallen", time, [], []);
    }

    #[state(last)]
    fn done(&mut self, time: &Time, lamp: &mut Lamp) {
        self.unit.body("done", time, [], [&mut lamp.unit]);
    }

    #[transition(wait | work -> fallen)]
    fn falls(&self, sensor: &Sensor) -> bool {
        self.unit.evaluate("falls", [sensor.unit.read()])
    }

    #[transition(wait -> work, after_ms = 100)]
    fn timer_wait(&self) -> bool {
        true
    }

    #[transition(work -> wait, after_ms = 250)]
    fn pause(&self, motor: &Motor) -> bool {
        self.unit.evaluate("pause", [motor.unit.read()])
    }

    #[transition(work -> wait, after_ms = 900)]
    fn timer_work(&self) -> bool {
        true
    }

    #[entry(work | done)]
    fn light(&mut self, lamp: &mut Lamp) {
        self.unit.hook("light", [], [&mut lamp.unit]);
    }

    #[exit(work)]
    fn dim(&mut self, sensor: &Sensor, lamp: &mut Lamp) {
        self.unit.hook("dim", [sensor.unit.read()], [&mut lamp.unit]);
    }

    #[entry(wait)]
    fn breathe(&mut self) {
        self.unit.hook("breathe", [], []);
    }

    #[exit(wait | fallen)]
    fn look(&mut self, eye: &Eye) {
        self.unit.hook("look", [eye.unit.read()], []);
    }

    #[entry(work)]
    fn beep(&mut self) {
        self.unit.hook("beep", [], []);
    }
} when {
    finish(work -> done);
    up(fallen -> wait, after_ms = 1);
});

macro_rules! leaf {
    ($name:ident($($hz:tt)*)) => {
        unit!($name($($hz)*) {
            fn step(&mut self, time: &Time) {
                self.unit.body("", time, [], []);
            }
        });
    };
}

leaf!(Sensor(hz = 40));
leaf!(Motor());
leaf!(Lamp(hz = 5));
leaf!(Eye());

activation_tree! {
    /// Timers, hooks, and transitions from several states.
    pub(crate) struct Timers {
        root: Owner,
        cycle_hz: 100,
        components: [Owner, Clockwork, Sensor, Motor, Lamp, Eye],
    }
}

test_tree!(
    Timers: [Owner, Clockwork, Sensor, Motor, Lamp, Eye],
    entry: [Clockwork.work: light, Clockwork.done: light, Clockwork.wait: breathe, Clockwork.work: beep],
    exit: [Clockwork.work: dim, Clockwork.wait: look, Clockwork.fallen: look]
);
