//! Probe that records the events.

use bica_core::{ComponentId, Graph, Instant, Probe, Tree};

/// Writes a line for each event: `run Head`, `Player: look -> walk`.
pub(crate) struct Watch {
    graph: Graph,
    pub(crate) lines: Vec<String>,
}

impl Watch {
    pub(crate) fn of<T: Tree>() -> Self {
        Self { graph: T::GRAPH, lines: Vec::new() }
    }

    fn record(&mut self, event: &str, component: ComponentId) {
        self.lines.push(format!("{event} {}", self.graph.nodes[component.index()].name));
    }
}

impl Probe for Watch {
    fn start(&mut self, component: ComponentId) {
        self.record("start", component);
    }

    fn stop(&mut self, component: ComponentId) {
        self.record("stop", component);
    }

    fn skip(&mut self, component: ComponentId) {
        self.record("skip", component);
    }

    fn run(&mut self, component: ComponentId) {
        self.record("run", component);
    }

    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        let node = &self.graph.nodes[component.index()];
        let (from, to) = (node.states[from].name, node.states[to].name);
        self.lines.push(format!("{}: {from} -> {to}", node.name));
    }
}

/// Returns the events of one cycle at this time, ms.
pub(crate) fn cycle<T: Tree>(tree: &mut T, ms: u64) -> Vec<String> {
    let mut watch = Watch::of::<T>();
    tree.tick_with(at(ms), &mut watch);
    watch.lines
}

/// Returns the names of the components that run in one cycle at this time, in order; ms.
pub(crate) fn runs<T: Tree>(tree: &mut T, ms: u64) -> Vec<String> {
    cycle(tree, ms).iter().filter_map(|line| line.strip_prefix("run ").map(str::to_owned)).collect()
}

pub(crate) fn at(ms: u64) -> Instant {
    Instant::from_millis(ms)
}
