//! Chain of components; children run slower and faster than their parents.

use bica::prelude::*;

use crate::support::test_tree::test_tree;
use crate::support::unit::unit;

unit!(Top() {
    fn step(&mut self, time: &Time, middle: &mut Middle) {
        self.unit.body("", time, [], [&mut middle.unit]);
    }
});

unit!(Middle(hz = 20) {
    fn step(&mut self, time: &Time, lower: &mut Lower) {
        self.unit.body("", time, [], [&mut lower.unit]);
    }
});

unit!(Lower(hz = 50) {
    fn step(&mut self, time: &Time, sensor: &Sensor) {
        self.unit.body("", time, [sensor.unit.read()], []);
    }
});

unit!(Sensor(hz = 30) {
    fn step(&mut self, time: &Time) {
        self.unit.body("", time, [], []);
    }
});

activation_tree! {
    /// Chain of components.
    pub(crate) struct Chain {
        root: Top,
        cycle_hz: 100,
        components: [Sensor, Top, Lower, Middle],
    }
}

test_tree!(Chain: [Sensor, Top, Lower, Middle]);
