//! State machine whose transitions carry values and that has functions before its transitions.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::{Carried, unit};

unit!(Chooser() {
    #[state(initial)]
    fn on(&mut self, time: &Time, taker: &mut Taker) {
        self.unit.body("on", time, [], [&mut taker.unit]);
    }

    #[state]
    fn off(&mut self, time: &Time) {
        self.unit.body("off", time, [], []);
    }

    #[before(on)]
    fn choose(&mut self) {
        self.unit.hook("choose", [], []);
    }
} when {
    put_off(on -> off);
    put_on(off -> on);
});

unit!(Taker(hz = 50) {
    #[state(initial)]
    fn search(&mut self, time: &Time, sensor: &Sensor) {
        self.unit.body("search", time, [sensor.unit.read()], []);
    }

    #[state]
    fn grasp(&mut self, time: &Time, motor: &mut Motor) {
        self.unit.body("grasp", time, [], [&mut motor.unit]);
    }

    #[state]
    fn lift(&mut self, time: &Time, motor: &mut Motor) {
        self.unit.body("lift", time, [], [&mut motor.unit]);
    }

    /// The function writes, and the conditions read the value that it computed in this run.
    #[before(search | lift)]
    fn plan(&mut self, sensor: &Sensor, motor: &mut Motor) {
        self.unit.hook("plan", [sensor.unit.read()], [&mut motor.unit]);
    }

    #[transition(search | lift -> grasp)]
    fn seen(&self, sensor: &Sensor) -> Option<Carried> {
        self.unit.find("seen", [sensor.unit.read()])
    }

    #[transition(search -> lift)]
    fn ready(&self) -> Option<(u64, Carried)> {
        self.unit.find("ready", []).map(|found| (0, found))
    }

    #[transition(* -> search, after_ms = 100)]
    fn lost(&self, motor: &Motor) -> Option<Carried> {
        self.unit.find("lost", [motor.unit.read()])
    }

    #[transition(grasp -> grasp)]
    fn again(&self) -> Option<Carried> {
        self.unit.find("again", [])
    }

    #[transition(grasp -> lift, after_ms = 60)]
    fn held(&self) -> Option<(u64, Carried)> {
        self.unit.find("held", []).map(|found| (0, found))
    }

    /// The hook changes the value that the conditions read.
    #[exit(search | grasp)]
    fn leave(&mut self, motor: &mut Motor) {
        self.unit.hook("leave", [], [&mut motor.unit]);
    }

    #[entry(grasp)]
    fn take(&mut self, found: Found<Carried>, motor: &mut Motor) {
        self.unit.take("take", Some(found.0), [], [&mut motor.unit]);
    }

    #[entry(search)]
    fn begin(&mut self, sensor: &Sensor, found: Option<Found<Carried>>) {
        self.unit.take("begin", found.map(|found| found.0), [sensor.unit.read()], []);
    }

    #[entry(lift)]
    fn pull(&mut self, Found((_, found)): Found<(u64, Carried)>) {
        self.unit.take("pull", Some(found), [], []);
    }

    #[entry(lift)]
    fn note(&mut self) {
        self.unit.hook("note", [], []);
    }
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

activation_tree! {
    /// Values that transitions carry.
    pub(crate) struct Carrying {
        root: Chooser,
        cycle_hz: 100,
        components: [Chooser, Taker, Sensor, Motor],
    }
}

test_tree!(
    Carrying: [Chooser, Taker, Sensor, Motor],
    entry: [Taker.grasp: take, Taker.search: begin, Taker.lift: pull, Taker.lift: note],
    exit: [Taker.search: leave, Taker.grasp: leave]
);
