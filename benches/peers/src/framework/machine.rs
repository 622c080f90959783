//! The machine of five states.

use bica::prelude::*;

use crate::framework::WorkloadTree;
use crate::machine::{input, work};

/// Five states in a ring.
pub struct Ring {
    input: u32,
    number: u64,
}

#[component]
impl Ring {
    const fn new() -> Self {
        Self { input: 0, number: 1 }
    }

    #[state(initial)]
    fn a(&mut self) {
        self.number = work::<0>(self.number);
    }

    #[state]
    fn b(&mut self) {
        self.number = work::<1>(self.number);
    }

    #[state]
    fn c(&mut self) {
        self.number = work::<2>(self.number);
    }

    #[state]
    fn d(&mut self) {
        self.number = work::<3>(self.number);
    }

    #[state]
    fn e(&mut self) {
        self.number = work::<4>(self.number);
    }

    #[transition(a -> b)]
    fn a_is_over(&self) -> bool {
        self.input.is_multiple_of(7)
    }

    #[transition(b -> c, after_ms = 50)]
    fn b_is_over(&self) -> bool {
        true
    }

    #[transition(c -> d)]
    fn c_is_over(&self) -> bool {
        self.input.is_multiple_of(5)
    }

    #[transition(d -> e, after_ms = 30)]
    fn d_is_over(&self) -> bool {
        true
    }

    #[transition(e -> a)]
    fn e_is_over(&self) -> bool {
        self.input.is_multiple_of(3)
    }
}

activation_tree! {
    /// Tree with one state machine.
    pub struct Machine {
        root: Ring,
        cycle_hz: 100,
        components: [Ring],
    }
}

impl WorkloadTree for Machine {
    fn create() -> Self {
        Self::new()
    }

    fn result(&self) -> u64 {
        self.get::<Ring>().number
    }

    fn set_input(&mut self, now: u64) {
        self.get_mut::<Ring>().input = input(now);
    }
}
