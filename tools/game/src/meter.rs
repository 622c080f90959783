//! The probe of the program: what ran how often and for how long, and whether the tree changed.

use std::time::{Duration, Instant as Clock};

use bica::graph::Graph;
use bica::{ComponentId, Instant, Probe};

/// What one component did in a game.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    /// Cycles in which it was active.
    pub active: u64,
    /// Times that its own code ran.
    pub runs: u64,
    /// Times that it became active.
    pub starts: u64,
    /// Time in its own code.
    pub time: Duration,
}

/// Sees all that a tree does.
pub struct Meter {
    /// For each component, in the order of the tree's list.
    pub work: Vec<Work>,
    /// What became active in this cycle.
    pub started: Vec<ComponentId>,
    /// What became latent in this cycle.
    pub stopped: Vec<ComponentId>,
    moved: bool,
    began: Clock,
}

impl Meter {
    /// Has seen nothing yet.
    pub fn new(graph: &Graph) -> Self {
        Self {
            work: vec![Work::default(); graph.nodes.len()],
            started: Vec::new(),
            stopped: Vec::new(),
            moved: false,
            began: Clock::now(),
        }
    }

    /// Whether the tree changed in this cycle: a component became active or latent, or a machine took a transition.
    pub fn changed(&self) -> bool {
        self.moved || !self.started.is_empty() || !self.stopped.is_empty()
    }
}

impl Probe for Meter {
    fn cycle_begin(&mut self, _now: Instant) {
        self.started.clear();
        self.stopped.clear();
        self.moved = false;
    }

    fn start(&mut self, component: ComponentId) {
        self.work[component.index()].starts += 1;
        self.started.push(component);
    }

    fn stop(&mut self, component: ComponentId) {
        self.stopped.push(component);
    }

    fn skip(&mut self, component: ComponentId) {
        self.work[component.index()].active += 1;
    }

    fn run(&mut self, component: ComponentId) {
        let work = &mut self.work[component.index()];
        work.active += 1;
        work.runs += 1;
    }

    fn begin(&mut self, _component: ComponentId) {
        self.began = Clock::now();
    }

    fn end(&mut self, component: ComponentId) {
        self.work[component.index()].time += self.began.elapsed();
    }

    fn transition(&mut self, _component: ComponentId, _from: usize, _to: usize) {
        self.moved = true;
    }
}
