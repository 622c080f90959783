//! Jobs beside the loop, of a step and of a machine.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::{job, unit};

unit!(Chief() {
    #[state(initial)]
    fn on(&mut self, time: &Time, thinker: &Thinker, muser: &mut Muser) {
        self.unit.body("on", time, [thinker.unit.read()], [&mut muser.unit]);
    }

    #[state]
    fn off(&mut self, time: &Time, muser: &Muser) {
        self.unit.body("off", time, [muser.unit.read()], []);
    }
} when {
    put_off(on -> off);
    put_on(off -> on);
});

unit!(Thinker(hz = 50) {
    #[work(takes_ms = 35)]
    fn think(value: u64, more: [u8; 3]) -> u64 {
        job(value).wrapping_add(more.len() as u64 - 3)
    }

    fn step(&mut self, time: &Time, work: &mut Work<Self>) {
        if let Some(value) = self.unit.works(work.result(), work.is_idle()) {
            work.begin(value, [0; 3]);
        }
        self.unit.body("", time, [], []);
    }
});

unit!(Muser(resume) {
    #[work(takes_ms = 7, slices)]
    fn muse(state: &mut (u64, u8)) -> Option<u64> {
        state.1 += 1;
        (state.1 == 3).then(|| job(state.0))
    }

    #[state(initial)]
    fn rest(&mut self, time: &Time) {
        self.unit.body("rest", time, [], []);
    }

    #[state]
    fn musing(&mut self, time: &Time, work: &mut Work<Self>) {
        if let Some(value) = self.unit.works(work.result(), work.is_idle()) {
            work.begin((value, 0));
        }
        self.unit.body("musing", time, [], []);
    }
} when {
    wake(rest -> musing);
    tire(musing -> rest);
});

activation_tree! {
    /// Work beside the loop.
    pub(crate) struct Works {
        root: Chief,
        cycle_hz: 100,
        components: [Chief, Thinker, Muser],
    }
}

test_tree!(Works: [Chief, Thinker, Muser]);
