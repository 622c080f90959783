//! Transitions during a test.

use core::fmt;
use std::vec::Vec;

use bica_core::graph::Graph;
use bica_core::{ComponentId, Instant, Probe};

use crate::observer::Observer;
use crate::robot::Robot;

/// Number of transitions in a message.
const SHOWN: usize = 20;

/// Transition of a state machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transition {
    /// Instant of the cycle.
    pub at: Instant,
    /// Name of the state machine.
    pub component: &'static str,
    /// Name of the state that was left.
    pub from: &'static str,
    /// Name of the state that was entered.
    pub to: &'static str,
}

/// All transitions of a test, oldest first.
#[derive(Clone, Debug)]
pub struct History {
    graph: Graph,
    now: Instant,
    transitions: Vec<Transition>,
}

impl History {
    pub(super) const fn new(graph: Graph) -> Self {
        Self { graph, now: Instant::MIN, transitions: Vec::new() }
    }

    /// Returns the transitions.
    #[must_use]
    pub fn transitions(&self) -> &[Transition] {
        &self.transitions
    }
}

impl Probe for History {
    fn cycle_begin(&mut self, now: Instant) {
        self.now = now;
    }

    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        let node = &self.graph.nodes[component.index()];
        let (from, to) = (node.states[from].name, node.states[to].name);
        self.transitions.push(Transition { at: self.now, component: node.name, from, to });
    }
}

impl<R: Robot> Observer<R> for History {}

/// Formats the last transitions, one per line.
impl fmt::Display for History {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let hidden = self.transitions.len().saturating_sub(SHOWN);
        if hidden > 0 {
            writeln!(f, "  ({hidden} earlier ones)")?;
        }
        for Transition { at, component, from, to } in &self.transitions[hidden..] {
            writeln!(f, "  {:>10.3} s  {component}: {from} -> {to}", at.as_micros() as f64 * 1e-6)?;
        }
        if self.transitions.is_empty() { writeln!(f, "  none") } else { Ok(()) }
    }
}
