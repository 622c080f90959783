//! The leaves with the crate `bonsai-bt`: actions below its `Sequence`, or below its `Select` without memory.

use bonsai_bt::{
    Action, ActionArgs, BT, Event, Float, RUNNING, Select, Sequence, Status, UpdateArgs, WaitForever, While,
};

use super::{LEAVES, STEPS, turn, work};
use crate::subject::{CYCLE_US, Subject};

/// Duration of a cycle, s.
const CYCLE: Float = CYCLE_US as Float * 1e-6;

/// What the leaves share.
struct Shared {
    now: u64,
    steps: u32,
    number: u64,
}

impl Shared {
    fn work(&mut self, leaf: usize) -> (Status, Float) {
        self.number = work(leaf, self.number);
        RUNNING
    }

    fn in_sequence(&mut self, leaf: usize, left: Float) -> (Status, Float) {
        if self.steps == STEPS {
            self.steps = 0;
            return (Status::Success, left);
        }
        self.steps += 1;
        self.work(leaf)
    }

    fn in_fallback(&mut self, leaf: usize, left: Float) -> (Status, Float) {
        if turn(self.now) == leaf { self.work(leaf) } else { (Status::Failure, left) }
    }
}

/// The leaves with `bonsai-bt`: a sequence, or the fallback.
pub struct Bonsai<const SEQUENCE: bool>(BT<usize, Shared>);

impl<const SEQUENCE: bool> Bonsai<SEQUENCE> {
    /// Creates the tree.
    #[must_use]
    pub fn new() -> Self {
        let leaves = (0..LEAVES).map(Action).collect();
        let control = if SEQUENCE { Sequence(leaves) } else { Select(leaves).memory(false) };
        // The loop begins a sequence that has succeeded anew in the same cycle.
        Self(BT::new(While(Box::new(WaitForever), vec![control]), Shared { now: 0, steps: 0, number: 1 }))
    }
}

impl<const SEQUENCE: bool> Default for Bonsai<SEQUENCE> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const SEQUENCE: bool> Subject for Bonsai<SEQUENCE> {
    fn cycle(&mut self, now: u64) {
        self.0.blackboard_mut().now = now;
        let event = Event::from(UpdateArgs { dt: CYCLE });
        // The tree never ends, so its result says nothing.
        _ = self.0.tick(&event, &mut |args: ActionArgs<Event, usize>, shared: &mut Shared| {
            if SEQUENCE { shared.in_sequence(*args.action, args.dt) } else { shared.in_fallback(*args.action, args.dt) }
        });
    }

    fn result(&self) -> u64 {
        self.0.blackboard().number
    }
}
