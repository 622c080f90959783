//! Ten leaves of a behavior tree as a machine of ten states.

use bica::prelude::*;

use crate::behavior_tree::{STEPS, turn, work};
use crate::framework::WorkloadTree;

/// Ten states in a ring: of a sequence, or of the fallback.
pub struct Leaves<const SEQUENCE: bool> {
    leaf: usize,
    steps: u32,
    now: u64,
    number: u64,
}

impl<const SEQUENCE: bool> Leaves<SEQUENCE> {
    #[inline]
    fn work(&mut self, leaf: usize) {
        if !SEQUENCE || self.leaf != leaf {
            (self.leaf, self.steps) = (leaf, 0);
        }
        self.steps += 1;
        self.number = work(leaf, self.number);
    }
}

#[component]
impl<const SEQUENCE: bool> Leaves<SEQUENCE> {
    const fn new() -> Self {
        Self { leaf: 0, steps: 0, now: 0, number: 1 }
    }

    #[state(initial)]
    fn leaf_0(&mut self) {
        self.work(0);
    }

    #[state]
    fn leaf_1(&mut self) {
        self.work(1);
    }

    #[state]
    fn leaf_2(&mut self) {
        self.work(2);
    }

    #[state]
    fn leaf_3(&mut self) {
        self.work(3);
    }

    #[state]
    fn leaf_4(&mut self) {
        self.work(4);
    }

    #[state]
    fn leaf_5(&mut self) {
        self.work(5);
    }

    #[state]
    fn leaf_6(&mut self) {
        self.work(6);
    }

    #[state]
    fn leaf_7(&mut self) {
        self.work(7);
    }

    #[state]
    fn leaf_8(&mut self) {
        self.work(8);
    }

    #[state]
    fn leaf_9(&mut self) {
        self.work(9);
    }

    #[transition(leaf_0 -> leaf_1)]
    #[transition(leaf_1 -> leaf_2)]
    #[transition(leaf_2 -> leaf_3)]
    #[transition(leaf_3 -> leaf_4)]
    #[transition(leaf_4 -> leaf_5)]
    #[transition(leaf_5 -> leaf_6)]
    #[transition(leaf_6 -> leaf_7)]
    #[transition(leaf_7 -> leaf_8)]
    #[transition(leaf_8 -> leaf_9)]
    #[transition(leaf_9 -> leaf_0)]
    fn is_over(&self) -> bool {
        if SEQUENCE { self.steps == STEPS } else { turn(self.now) != self.leaf }
    }
}

/// Tree with the machine.
macro_rules! tree {
    ($tree:ident, $sequence:literal, $doc:literal) => {
        activation_tree! {
            #[doc = $doc]
            pub struct $tree {
                root: Leaves<$sequence>,
                cycle_hz: 100,
                components: [Leaves<$sequence>],
            }
        }

        impl WorkloadTree for $tree {
            fn create() -> Self {
                Self::new()
            }

            fn result(&self) -> u64 {
                self.get::<Leaves<$sequence>>().number
            }

            fn set_input(&mut self, now: u64) {
                self.get_mut::<Leaves<$sequence>>().now = now;
            }
        }
    };
}

tree!(Sequence, true, "Tree with a sequence.");
tree!(Fallback, false, "Tree with a fallback.");
