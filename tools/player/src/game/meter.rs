//! Activity and cost of the components, and changes of the tree.

use std::time::{Duration, Instant as Clock};

use bica::graph::Graph;
use bica::runner::Observer;
use bica::{ComponentId, Instant, Probe};
use bica_player::tunable::Forward;

/// Activity of a component in a game.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Activity {
    /// Cycles in which it was active.
    pub(crate) active: u64,
    /// Number of runs.
    pub(crate) runs: u64,
    /// Number of activations.
    pub(crate) starts: u64,
    /// Time in its own code.
    pub(crate) time: Duration,
}

/// Probe that measures all components.
#[derive(Debug)]
pub(crate) struct Meter {
    /// Activity of each component, in the order of the tree.
    pub(crate) activity: Vec<Activity>,
    /// Components that became active in this cycle.
    pub(crate) started: Vec<ComponentId>,
    /// Components that became latent in this cycle.
    pub(crate) stopped: Vec<ComponentId>,
    has_transition: bool,
    began: Clock,
}

impl Meter {
    /// A meter without cycles.
    pub(crate) fn new(graph: &Graph) -> Self {
        Self {
            activity: vec![Activity::default(); graph.nodes.len()],
            started: Vec::new(),
            stopped: Vec::new(),
            has_transition: false,
            began: Clock::now(),
        }
    }

    /// Returns whether the tree changed in this cycle: a component became active or latent, or a transition was taken.
    pub(crate) fn changed(&self) -> bool {
        self.has_transition || !self.started.is_empty() || !self.stopped.is_empty()
    }
}

impl Probe for Meter {
    fn cycle_begin(&mut self, _now: Instant) {
        self.started.clear();
        self.stopped.clear();
        self.has_transition = false;
    }

    fn start(&mut self, component: ComponentId) {
        self.activity[component.index()].starts += 1;
        self.started.push(component);
    }

    fn stop(&mut self, component: ComponentId) {
        self.stopped.push(component);
    }

    fn skip(&mut self, component: ComponentId) {
        self.activity[component.index()].active += 1;
    }

    fn run(&mut self, component: ComponentId) {
        let activity = &mut self.activity[component.index()];
        activity.active += 1;
        activity.runs += 1;
    }

    fn begin(&mut self, _component: ComponentId) {
        self.began = Clock::now();
    }

    fn end(&mut self, component: ComponentId) {
        self.activity[component.index()].time += self.began.elapsed();
    }

    fn transition(&mut self, _component: ComponentId, _from: usize, _to: usize) {
        self.has_transition = true;
    }
}

impl Observer<Forward> for Meter {}
