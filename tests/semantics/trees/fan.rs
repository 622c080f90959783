//! Component with many children.

use bica::prelude::*;

use crate::support::test_tree::test_tree;
use crate::support::unit::unit;

unit!(Hub(hz = 25) {
    fn step(&mut self, time: &Time, a: &First, d: &mut Fourth, b: &Second, e: &mut Fifth, c: &Third) {
        let reads = [c.unit.read(), a.unit.read(), b.unit.read()];
        self.unit.body("", time, reads, [&mut d.unit, &mut e.unit]);
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

leaf!(First(hz = 10));
leaf!(Second());
leaf!(Third(hz = 33.3));
leaf!(Fourth(hz = 5));
leaf!(Fifth());

activation_tree! {
    /// Component with five children.
    pub(crate) struct Fan {
        root: Hub,
        cycle_hz: 100,
        components: [Second, Hub, First, Fifth, Third, Fourth],
    }
}

test_tree!(Fan: [Second, Hub, First, Fifth, Third, Fourth]);
