//! A probe with a clock.

use std::time::Instant as Clock;

use bica::prelude::*;
use bica_player::Forward;

/// Time that each component took in one cycle, ns; `None` if it did not run.
pub(crate) struct Stopwatch {
    pub(crate) spent: [Option<u32>; Forward::COUNT],
    began: Clock,
}

impl Stopwatch {
    pub(crate) fn new() -> Self {
        Self { spent: [None; Forward::COUNT], began: Clock::now() }
    }
}

impl Probe for Stopwatch {
    fn cycle_begin(&mut self, _: Instant) {
        self.spent = [None; Forward::COUNT];
    }

    fn begin(&mut self, _: ComponentId) {
        self.began = Clock::now();
    }

    fn end(&mut self, component: ComponentId) {
        let spent = self.began.elapsed().as_nanos() as u32;
        // A run has two stretches if its machine took a transition.
        let sum = &mut self.spent[component.index()];
        *sum = Some(sum.unwrap_or(0).saturating_add(spent));
    }
}
