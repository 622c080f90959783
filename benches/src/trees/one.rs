//! Tree of one component: the cost of the tick itself.

use bica::prelude::*;

/// The component.
pub struct Only(u64);

#[component]
impl Only {
    const fn new() -> Self {
        Self(1)
    }

    fn step(&mut self) {
        self.0 = self.0.wrapping_mul(31).wrapping_add(1);
    }
}

activation_tree! {
    /// One component.
    pub struct One { root: Only, cycle_hz: 1000, components: [Only] }
}
