//! Figure 4 of the paper: a child with several activators, which read and write it.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::unit;

unit!(Root(hz = 40) {
    fn step(&mut self, time: &Time, right: &mut Right, left: &Left, far: &mut Far) {
        self.unit.body("", time, [left.unit.read()], [&mut right.unit, &mut far.unit]);
    }
});

unit!(Left(hz = 15) {
    fn step(&mut self, time: &Time, eye: &Eye, shared: &Shared) {
        self.unit.body("", time, [shared.unit.read(), eye.unit.read()], []);
    }
});

unit!(Right() {
    fn step(&mut self, time: &Time, shared: &mut Shared, eye: &Eye) {
        self.unit.body("", time, [eye.unit.read()], [&mut shared.unit]);
    }
});

unit!(Far(hz = 30) {
    fn step(&mut self, time: &Time, eye: &Eye, shared: &mut Shared) {
        self.unit.body("", time, [eye.unit.read()], [&mut shared.unit]);
    }
});

unit!(Shared(hz = 25, writers = first));

unit!(Eye(hz = 30));

activation_tree! {
    /// Child with three activators.
    pub(crate) struct Diamond {
        root: Root,
        cycle_hz: 100,
        components: [Root, Right, Left, Far, Shared, Eye],
    }
}

test_tree!(Diamond: [Root, Right, Left, Far, Shared, Eye]);
