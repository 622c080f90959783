//! Parents that set the rates of their children.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::unit;

unit!(Boss(hz = 40) {
    fn step(&mut self, time: &Time, worker: &mut Worker, rate: &mut Rate<Worker>) {
        self.unit.modulate("Worker", rate);
        self.unit.body("", time, [], [&mut worker.unit]);
    }
});

unit!(Worker(hz = 50) {
    #[state(initial)]
    fn calm(&mut self, time: &Time, eye: &Eye) {
        self.unit.body("calm", time, [eye.unit.read()], []);
    }

    #[state]
    fn alert(&mut self, time: &Time, eye: &mut Rate<Eye>, hand: &mut Rate<Hand>) {
        self.unit.modulate("Eye", eye);
        self.unit.modulate("Hand", hand);
        self.unit.body("alert", time, [], []);
    }

    #[entry(alert)]
    fn shout(&mut self, hand: &mut Hand) {
        self.unit.hook("shout", [], [&mut hand.unit]);
    }
} when {
    wake(calm -> alert);
    doze(alert -> calm);
});

unit!(Eye(hz = 60));

unit!(Hand());

activation_tree! {
    /// Rates set by parents.
    pub(crate) struct Modulated {
        root: Boss,
        cycle_hz: 100,
        components: [Boss, Worker, Eye, Hand],
    }
}

test_tree!(Modulated: [Boss, Worker, Eye, Hand], entry: [Worker.alert: shout]);
