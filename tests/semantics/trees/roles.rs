//! Components that use roles. One provider has two roles and is also named directly; another provider uses a role itself.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::{Unit, unit};

#[role]
trait Sight {
    fn seen(&self) -> &Unit;
}

#[role]
trait Hand {
    fn held(&self) -> &Unit;

    fn moved(&mut self) -> &mut Unit;
}

#[role]
trait Reach {
    fn reached(&self) -> &Unit;

    fn stretched(&mut self) -> &mut Unit;
}

unit!(Scout(hz = 40) {
    #[state(initial)]
    fn look(&mut self, time: &Time, sight: &impl Sight, hand: &impl Hand, reach: &impl Reach, arm: &Arm) {
        let reads = [sight.seen().read(), hand.held().read(), reach.reached().read(), arm.unit.read()];
        self.unit.body("look", time, reads, []);
    }

    #[state]
    fn grab(&mut self, time: &Time, hand: &mut impl Hand) {
        self.unit.body("grab", time, [], [hand.moved()]);
    }

    #[state]
    fn rest(&mut self, time: &Time, sight: &mut impl Sight) {
        self.unit.body("rest", time, [sight.seen().read()], []);
    }

    #[transition(look -> grab)]
    #[transition(rest -> grab)]
    fn near(&self, sight: &impl Sight) -> bool {
        self.unit.evaluate("near", [sight.seen().read()])
    }

    #[transition(grab -> rest)]
    fn held(&self, arm: &Arm) -> bool {
        self.unit.evaluate("held", [arm.unit.read()])
    }

    #[transition(* -> look)]
    fn lost(&self, reach: &impl Reach) -> bool {
        self.unit.evaluate("lost", [reach.reached().read()])
    }

    #[entry(grab)]
    fn stretch(&mut self, reach: &mut impl Reach, sight: &impl Sight) {
        let read = sight.seen().read();
        self.unit.hook("stretch", [read], [reach.stretched()]);
    }
});

unit!(Arm(hz = 60) {
    fn step(&mut self, time: &Time, sight: &impl Sight) {
        let read = sight.seen().read();
        self.unit.body("", time, [read], []);
    }
});

impl Hand for Arm {
    fn held(&self) -> &Unit {
        &self.unit
    }

    fn moved(&mut self) -> &mut Unit {
        &mut self.unit
    }
}

impl Reach for Arm {
    fn reached(&self) -> &Unit {
        &self.unit
    }

    fn stretched(&mut self) -> &mut Unit {
        &mut self.unit
    }
}

unit!(Eye());

impl Sight for Eye {
    fn seen(&self) -> &Unit {
        &self.unit
    }
}

activation_tree! {
    /// Three roles of two providers.
    pub(crate) struct Asking {
        root: Scout,
        cycle_hz: 100,
        roles: { Sight: Eye, Hand: Arm, Reach: Arm },
        components: [Scout, Arm, Eye],
    }
}

test_tree!(Asking: [Scout, Arm, Eye], entry: [Scout.grab: stretch]);
