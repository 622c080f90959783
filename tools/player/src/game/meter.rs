//! Activity and cost of the components, and changes of the tree.

use bica::graph::Graph;
use bica::runner::Observer;
use bica::{ComponentId, Instant, Probe};
use bica_link::CostMeter;
use bica_player::tunable::Forward;

/// Activity of a component in a game.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Activity {
    /// Number of cycles in which it was active.
    pub(crate) active: u64,
    /// Number of activations.
    pub(crate) starts: u64,
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
    /// Runs and times since the start.
    pub(crate) costs: CostMeter,
    has_transition: bool,
}

impl Meter {
    /// Creates a meter without cycles.
    pub(crate) fn new(graph: &'static Graph) -> Self {
        let mut costs = CostMeter::new(graph);
        costs.switch(true);
        Self {
            costs,
            activity: vec![Activity::default(); graph.nodes.len()],
            started: Vec::new(),
            stopped: Vec::new(),
            has_transition: false,
        }
    }

    /// Returns whether the tree changed in this cycle: a component became active or latent, or a transition was taken.
    pub(crate) fn changed(&self) -> bool {
        self.has_transition || !self.started.is_empty() || !self.stopped.is_empty()
    }
}

impl Probe for Meter {
    fn cycle_begin(&mut self, now: Instant) {
        self.costs.cycle_begin(now);
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
        self.activity[component.index()].active += 1;
        self.costs.run(component);
    }

    fn begin(&mut self, component: ComponentId) {
        self.costs.begin(component);
    }

    fn end(&mut self, component: ComponentId) {
        self.costs.end(component);
    }

    fn cycle_end(&mut self) {
        self.costs.cycle_end();
    }

    fn transition(&mut self, _component: ComponentId, _from: usize, _to: usize) {
        self.has_transition = true;
    }
}

impl Observer<Forward> for Meter {}
