//! State machine that changes its state, and with it the active set, in every cycle.

use bica::prelude::*;

macro_rules! leaf {
    ($name:ident) => {
        #[doc = "Child of one state."]
        pub struct $name(u64);

        #[component]
        impl $name {
            const fn new() -> Self {
                Self(1)
            }

            fn step(&mut self) {
                self.0 = self.0.wrapping_mul(31).wrapping_add(1);
            }
        }
    };
}
leaf!(Left);
leaf!(Right);

/// State machine with one child for each state.
pub struct Root {
    /// Whether the state changes in every cycle.
    pub changes: bool,
}

#[component]
impl Root {
    const fn new() -> Self {
        Self { changes: true }
    }

    #[state(initial)]
    fn left(&mut self, _left: &mut Left) {}

    #[state]
    fn right(&mut self, _right: &mut Right) {}

    #[transition(left -> right)]
    fn to_right(&self) -> bool {
        self.changes
    }

    #[transition(right -> left)]
    fn to_left(&self) -> bool {
        self.changes
    }
}

activation_tree! {
    /// In every cycle one component becomes active and another one latent.
    pub struct Switch { root: Root, cycle_hz: 1000, components: [Root, Left, Right] }
}
