//! Machines that wait for the results of others: one child before and one after its parent, one child of two parents.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::{ended, unit};

/// Times of the picker.
#[derive(Params)]
pub(crate) struct Picking {
    /// Pause before the next attempt.
    #[param(default = 0.03, range = 0.0..=60.0, unit = "s")]
    pause: f32,
}

unit!(Boss() {
    #[state(initial)]
    fn on(&mut self, time: &Time, picker: &mut Picker, helper: &mut Helper, grip: &Grip) {
        self.unit.body("on", time, [grip.unit.read()], [&mut picker.unit, &mut helper.unit]);
    }

    #[state]
    fn off(&mut self, time: &Time, helper: &mut Helper) {
        self.unit.body("off", time, [], [&mut helper.unit]);
    }
} when {
    put_off(on -> off);
    put_on(off -> on);
});

unit!(Picker(hz = 50, resume) {
    #[state(initial)]
    #[transition(reach -> lift, when = done(Reach))]
    #[transition(reach -> wait, when = failed(Reach), times = 2)]
    #[transition(reach -> idle, when = failed(Reach))]
    fn reach(&mut self, time: &Time, reach: &mut Reach) {
        self.unit.body("reach", time, [], [&mut reach.unit]);
    }

    #[state]
    #[transition(wait -> reach, after = Picking::pause)]
    fn wait(&mut self, time: &Time) {
        self.unit.body("wait", time, [], []);
    }

    #[transition(lift -> lift, when = failed(Grip), times = 3)]
    fn again(&self, grip: &Grip) -> bool {
        self.unit.evaluate("again", [grip.unit.read()])
    }

    #[state]
    #[transition(lift -> idle, when = done(Grip))]
    #[transition(lift -> reach, when = failed(Grip), times = 1)]
    fn lift(&mut self, time: &Time, grip: &Grip) {
        self.unit.body("lift", time, [grip.unit.read()], []);
    }

    #[state]
    fn idle(&mut self, time: &Time, grip: &Grip) {
        self.unit.body("idle", time, [grip.unit.read()], []);
    }

    #[entry(lift)]
    fn close(&mut self, grip: &Grip) {
        self.unit.hook("close", [grip.unit.read()], []);
    }
} when {
    go_on(idle | wait -> lift);
});

unit!(Helper(hz = 40) {
    #[state(initial)]
    #[transition(help -> rest, when = failed(Reach))]
    fn help(&mut self, time: &Time, reach: &mut Reach) {
        self.unit.body("help", time, [], [&mut reach.unit]);
    }

    #[transition(help -> rest)]
    fn gives_up(&self, reach: &Outcome<Reach>) -> bool {
        ended("Reach", reach);
        self.unit.evaluate("gives_up", [])
    }

    #[state]
    #[transition(rest -> help, after_ms = 40)]
    fn rest(&mut self, time: &Time) {
        self.unit.body("rest", time, [], []);
    }
});

unit!(Reach(writers = first) {
    #[state(initial)]
    fn go(&mut self, time: &Time) {
        self.unit.body("go", time, [], []);
    }

    #[state(done)]
    fn there(&mut self, time: &Time, motor: &mut Motor) {
        self.unit.body("there", time, [], [&mut motor.unit]);
    }

    #[state(failed)]
    fn stuck(&mut self, time: &Time) {
        self.unit.body("stuck", time, [], []);
    }

    #[entry(go)]
    fn aim(&mut self) {
        self.unit.hook("aim", [], []);
    }
} when {
    arrives(go -> there);
    blocked(go -> stuck, after_ms = 20);
});

unit!(Grip(hz = 30, resume) {
    #[state(initial)]
    fn open(&mut self, time: &Time) {
        self.unit.body("open", time, [], []);
    }

    #[state(done)]
    fn holds(&mut self, time: &Time) {
        self.unit.body("holds", time, [], []);
    }

    #[state(failed)]
    fn empty(&mut self, time: &Time) {
        self.unit.body("empty", time, [], []);
    }
} when {
    touches(open -> holds);
    misses(open -> empty);
});

unit!(Motor());

activation_tree! {
    /// Results of machines.
    pub(crate) struct Results {
        root: Boss,
        cycle_hz: 100,
        components: [Boss, Picker, Helper, Reach, Grip, Motor],
    }
}

test_tree!(
    Results: [Boss, Picker, Helper, Reach, Grip, Motor],
    entry: [Picker.lift: close, Reach.go: aim],
    exit: [],
    outcomes: [Helper.gives_up: Reach]
);
