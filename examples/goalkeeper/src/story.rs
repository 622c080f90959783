//! Transitions of the goalkeeper as text.

use bica::runner::{Cycle, Observer};
use bica::{ComponentId, Instant, Probe, Tree};

use crate::{Goalkeeper, Keeper};

/// Collects the transitions of the goalkeeper as lines of text.
#[derive(Clone, Debug)]
pub struct Story {
    now: Instant,
    /// Lines since they were last taken.
    lines: Vec<String>,
}

impl Story {
    /// Creates a story without a line.
    #[must_use]
    pub const fn new() -> Self {
        Self { now: Instant::MIN, lines: Vec::new() }
    }

    /// Returns the lines since the last call.
    pub fn take(&mut self) -> Vec<String> {
        std::mem::take(&mut self.lines)
    }
}

impl Default for Story {
    fn default() -> Self {
        Self::new()
    }
}

impl Probe for Story {
    fn cycle_begin(&mut self, now: Instant) {
        self.now = now;
    }

    fn transition(&mut self, component: ComponentId, _from: usize, to: usize) {
        if component == Keeper::id::<Goalkeeper>() {
            let state = &Keeper::GRAPH.nodes[component.index()].states[to];
            let seconds = self.now.as_micros() as f64 * 1e-6;
            self.lines.push(format!("{seconds:6.2} s  {:14} {}", state.name, state.doc.trim()));
        }
    }
}

impl Observer<Keeper> for Story {
    fn acted(&mut self, _cycle: &Cycle<'_, Keeper>) {}
}
