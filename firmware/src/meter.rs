//! Costs of the components, log of the transitions, and injection of faults.

use core::marker::PhantomData;

use bica::runner::Observer;
use bica::{ComponentId, Probe, Tree};
use bica_wire::message::FaultInjection;

use crate::board::Board;
use crate::faults::Faults;
use crate::tree::{Forward, GRAPH};

/// An observer that measures with the counter of board `B`.
pub(crate) struct Meter<B> {
    /// Time spent in each component's own code in this cycle, counter ticks, little-endian.
    costs: [[u8; 4]; Forward::COUNT],
    start: u32,
    faults: Faults,
    board: PhantomData<B>,
}

impl<B: Board> Meter<B> {
    /// Creates a meter without costs and faults.
    pub(crate) const fn new() -> Self {
        Self { costs: [[0; 4]; Forward::COUNT], start: 0, faults: Faults::NONE, board: PhantomData }
    }

    /// Injects a fault.
    pub(crate) fn inject(&mut self, fault: FaultInjection) {
        self.faults.inject(fault);
    }

    /// Returns the costs of all components in this cycle: four bytes each, counter ticks, little-endian.
    pub(crate) const fn costs(&self) -> &[u8] {
        self.costs.as_flattened()
    }
}

fn name(component: ComponentId) -> &'static str {
    GRAPH.nodes[component.index()].name
}

fn state(component: ComponentId, state: usize) -> &'static str {
    GRAPH.nodes[component.index()].states[state].name
}

impl<B: Board> Probe for Meter<B> {
    fn cycle_begin(&mut self, _now: bica::Instant) {
        self.costs = [[0; 4]; Forward::COUNT];
    }

    fn begin(&mut self, component: ComponentId) {
        self.start = B::counter();
        self.faults.before_run(component.index(), name(component));
    }

    fn end(&mut self, component: ComponentId) {
        self.faults.after_run::<B>(component.index());
        let cost = &mut self.costs[component.index()];
        *cost = u32::from_le_bytes(*cost).wrapping_add(B::counter().wrapping_sub(self.start)).to_le_bytes();
    }

    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        defmt::info!("{=str}: {=str} -> {=str}", name(component), state(component, from), state(component, to));
    }
}

impl<B: Board> Observer<Forward> for Meter<B> {}
