//! Ten levels, each with links to the next two.

use bica::prelude::*;

use crate::semantics::random::test_tree::test_tree;
use crate::semantics::random::unit::unit;

macro_rules! level {
    ($name:ident($($hz:tt)*) writes $next:ident reads $after:ident) => {
        unit!($name($($hz)*) {
            fn step(&mut self, time: &Time, after: &$after, next: &mut $next) {
                self.unit.body("", time, [after.unit.read()], [&mut next.unit]);
            }
        });
    };
}

level!(Level0(hz = 10) writes Level1 reads Level2);
level!(Level1(hz = 100) writes Level2 reads Level3);
level!(Level2() writes Level3 reads Level4);
level!(Level3(hz = 5) writes Level4 reads Level5);
level!(Level4(hz = 60) writes Level5 reads Level6);
level!(Level5(hz = 30) writes Level6 reads Level7);
level!(Level6() writes Level7 reads Level8);
level!(Level7(hz = 20) writes Level8 reads Level9);

unit!(Level8(hz = 45) {
    fn step(&mut self, time: &Time, next: &mut Level9) {
        self.unit.body("", time, [], [&mut next.unit]);
    }
});

unit!(Level9(hz = 1) {
    fn step(&mut self, time: &Time) {
        self.unit.body("", time, [], []);
    }
});

activation_tree! {
    /// Ten levels.
    pub(crate) struct Deep {
        root: Level0,
        cycle_hz: 100,
        components: [Level9, Level7, Level8, Level6, Level5, Level0, Level4, Level3, Level1, Level2],
    }
}

test_tree!(Deep: [Level9, Level7, Level8, Level6, Level5, Level0, Level4, Level3, Level1, Level2]);
