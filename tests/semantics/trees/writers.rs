//! Children of several writers: of one the first counts, of the others the last, also where one of them writes the other.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::unit;

unit!(Pilot() {
    #[state(initial)]
    fn all(&mut self, time: &Time, eye: &Eye, avoid: &mut Avoid, follow: &mut Follow) {
        self.unit.body("all", time, [eye.unit.read()], [&mut avoid.unit, &mut follow.unit]);
    }

    #[state]
    fn alone(&mut self, time: &Time, drive: &mut Drive, follow: &mut Follow) {
        self.unit.body("alone", time, [], [&mut drive.unit, &mut follow.unit]);
    }

    #[state(last)]
    fn ended(&mut self, time: &Time) {
        self.unit.body("ended", time, [], []);
    }

    #[transition(all -> alone)]
    fn parts(&self, drive: &Drive) -> bool {
        self.unit.evaluate("parts", [drive.unit.read()])
    }
} when {
    meets(alone -> all);
    ends(alone -> ended, when = done(Drive));
});

unit!(Avoid(hz = 50) {
    fn step(&mut self, time: &Time, drive: &mut Drive, wheel: &mut Wheel) {
        self.unit.body("", time, [], [&mut drive.unit, &mut wheel.unit]);
    }
});

unit!(Follow(resume) {
    #[state(initial)]
    fn near(&mut self, time: &Time, drive: &mut Drive, lamp: &mut Lamp) {
        self.unit.body("near", time, [], [&mut drive.unit, &mut lamp.unit]);
    }

    #[state]
    fn far(&mut self, time: &Time, drive: &Drive) {
        self.unit.body("far", time, [drive.unit.read()], []);
    }

    #[transition(near -> far)]
    fn loses(&self, drive: &Drive) -> bool {
        self.unit.evaluate("loses", [drive.unit.read()])
    }
} when {
    finds(far -> near, after_ms = 30);
});

unit!(Drive(hz = 60, writers = last) {
    #[state(initial)]
    fn rolls(&mut self, time: &Time, wheel: &mut Wheel, lamp: &mut Lamp) {
        self.unit.body("rolls", time, [], [&mut wheel.unit, &mut lamp.unit]);
    }

    #[state]
    fn brakes(&mut self, time: &Time, eye: &Eye, wheel: &mut Wheel) {
        self.unit.body("brakes", time, [eye.unit.read()], [&mut wheel.unit]);
    }

    #[state(done)]
    fn stands(&mut self, time: &Time) {
        self.unit.body("stands", time, [], []);
    }
} when {
    slows(rolls -> brakes);
    speeds(brakes -> rolls);
    halts(brakes -> stands, after_ms = 50);
});

unit!(Wheel(writers = first));

unit!(Lamp(hz = 30, writers = last));

unit!(Eye(hz = 40) {
    fn step(&mut self, time: &Time, lamp: &Lamp) {
        self.unit.body("", time, [lamp.unit.read()], []);
    }
});

activation_tree! {
    /// Children of several writers.
    pub(crate) struct Writers {
        root: Pilot,
        cycle_hz: 100,
        components: [Lamp, Pilot, Drive, Avoid, Follow, Wheel, Eye],
    }
}

test_tree!(Writers: [Lamp, Pilot, Drive, Avoid, Follow, Wheel, Eye]);
