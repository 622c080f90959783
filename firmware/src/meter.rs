//! What a cycle costs, and what changes in it: the probe that measures, logs, and puts components to the test.

use core::marker::PhantomData;

use bica::{ComponentId, Probe, Tree};
use bica_player::Forward;
use bica_wire::message::FaultInjection;

use crate::board::Board;

/// Measures by the fine clock of board `B`.
pub(crate) struct Meter<B> {
    /// Fine ticks in each component's own code in this cycle, the lowest byte first.
    pub(crate) costs: [[u8; 4]; Forward::COUNT],
    began: u32,
    slow: Option<(usize, u32)>,
    panics: Option<usize>,
    board: PhantomData<B>,
}

impl<B: Board> Meter<B> {
    /// Has measured nothing yet.
    pub(crate) const fn new() -> Self {
        Self { costs: [[0; 4]; Forward::COUNT], began: 0, slow: None, panics: None, board: PhantomData }
    }

    /// Puts a component to a test.
    pub(crate) const fn test(&mut self, trial: FaultInjection) {
        match trial {
            FaultInjection::Delay { ticks: 0, .. } => self.slow = None,
            FaultInjection::Delay { component, ticks } => self.slow = Some((component as usize, ticks)),
            FaultInjection::Panic { component } => self.panics = Some(component as usize),
        }
    }
}

fn name(component: ComponentId) -> &'static str {
    Forward::GRAPH.nodes[component.index()].name
}

fn state(component: ComponentId, state: usize) -> &'static str {
    Forward::GRAPH.nodes[component.index()].states[state].name
}

impl<B: Board> Probe for Meter<B> {
    fn cycle_begin(&mut self, _now: bica::Instant) {
        self.costs = [[0; 4]; Forward::COUNT];
    }

    fn begin(&mut self, component: ComponentId) {
        self.began = B::fine();
        assert!(self.panics != Some(component.index()), "injected: {} panics", name(component));
    }

    fn end(&mut self, component: ComponentId) {
        if let Some((_, ticks)) = self.slow.filter(|&(slow, _)| slow == component.index()) {
            let began = B::fine();
            while B::fine().wrapping_sub(began) < ticks {}
        }
        let cost = &mut self.costs[component.index()];
        *cost = u32::from_le_bytes(*cost).wrapping_add(B::fine().wrapping_sub(self.began)).to_le_bytes();
    }

    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        defmt::info!("{=str}: {=str} -> {=str}", name(component), state(component, from), state(component, to));
    }
}
