//! Transitions as lines of text.

use bica::graph::WorkFunction;
use bica::runner::{ClockStep, Observer, Robot};
use bica::{ComponentId, Graph, Instant, JobEnd, Probe};
use serde::Serialize;

use crate::console::{Console, Failure};

/// Collects the transitions of the root, or of all components if the root has no states.
#[derive(Debug)]
pub(crate) struct Story {
    graph: &'static Graph,
    now: Instant,
    pub(super) changes: Vec<StateChange>,
    /// Number of transitions that have been printed.
    printed: usize,
    /// For each component the number of jobs that have ended, of those that were late, and of those that have failed.
    jobs: Vec<[u64; 3]>,
}

/// A transition.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct StateChange {
    /// Time of the world, s.
    t: f64,
    component: &'static str,
    state: &'static str,
    #[serde(skip)]
    doc: &'static str,
}

impl Story {
    pub(super) fn new(graph: &'static Graph) -> Self {
        Self { graph, now: Instant::MIN, changes: Vec::new(), printed: 0, jobs: vec![[0; 3]; graph.nodes.len()] }
    }

    /// Describes the jobs of each component with work.
    pub(super) fn jobs(&self) -> impl Iterator<Item = String> {
        let works =
            self.graph.nodes.iter().zip(&self.jobs).filter_map(|(node, jobs)| Some((node.name, node.work?, jobs)));
        works.map(|(component, work, [ended, late, failed])| {
            let WorkFunction { name, takes_ms, .. } = work;
            format!("{component}.{name}: {ended} jobs of {takes_ms} ms have ended, {late} late, {failed} failed")
        })
    }

    /// Prints the transitions since the last call.
    pub(super) fn print(&mut self, console: Console) -> Result<(), Failure> {
        for StateChange { t, component, state, doc } in &self.changes[self.printed..] {
            console.print(&format!("{t:8.2} s  {component}:{state:16} {}", doc.lines().next().unwrap_or_default()))?;
        }
        self.printed = self.changes.len();
        Ok(())
    }
}

impl Probe for Story {
    fn cycle_begin(&mut self, now: Instant) {
        self.now = now;
    }

    fn work_ended(&mut self, component: ComponentId, end: JobEnd) {
        let [ended, late, failed] = &mut self.jobs[component.index()];
        *ended += 1;
        *late += u64::from(end == JobEnd::Late);
        *failed += u64::from(end == JobEnd::Failed);
    }

    fn transition(&mut self, component: ComponentId, _from: usize, to: usize) {
        let root = &self.graph.nodes[self.graph.root];
        if root.states.is_empty() || component.index() == self.graph.root {
            let node = &self.graph.nodes[component.index()];
            let (t, state) = (self.now.as_micros() as f64 * 1e-6, &node.states[to]);
            self.changes.push(StateChange { t, component: node.name, state: state.name, doc: state.doc.trim() });
        }
    }
}

impl<R: Robot> Observer<R> for Story {
    fn clock_stepped(&mut self, _now: Instant, step: &ClockStep) {
        eprintln!("warning: {step}");
    }
}
