//! Figures of a world: quantiles of the times, and exceeded budgets.

use bica::Graph;
use bica::check::{longest_chain, steps};
use serde::Serialize;

use super::measure::{PHASES, Times};

/// Figures of a robot in a world, over all seeds.
#[derive(Debug, Serialize)]
pub(super) struct Figures {
    schema: &'static str,
    pub(super) robot: &'static str,
    pub(super) world: String,
    seeds: Vec<u64>,
    /// `budget_ms` of the tree.
    pub(super) deadline_ms: Option<f32>,
    pub(super) components: Vec<Row>,
    pub(super) phases: Vec<Row>,
    /// Messages about exceeded budgets, one for each; a message begins with the name.
    pub(super) exceeded: Vec<String>,
}

/// Times of one run of a component or phase, µs. All but `ever_us` use the minima over the repetitions.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    pub(super) name: &'static str,
    pub(super) runs: usize,
    pub(super) p50_us: f64,
    pub(super) p99_us: f64,
    pub(super) max_us: f64,
    /// Largest time in any repetition, including all interruptions.
    pub(super) ever_us: f64,
    /// Declared budget. For the whole chain: the largest sum of budgets in one cycle, plus the slowest runs of all
    /// components without a budget.
    pub(super) declared_us: Option<f64>,
}

impl Figures {
    /// Figures of the runs with these seeds.
    pub(super) fn new(graph: &'static Graph, world: &str, seeds: &[u64], times: &[Times]) -> Self {
        let budgets: Vec<_> = graph.nodes.iter().map(|node| node.budget_us.map(f64::from)).collect();
        let mut components: Vec<_> =
            graph.nodes.iter().enumerate().map(|(at, node)| Row::new(node.name, at, times)).collect();
        for (row, budget) in components.iter_mut().zip(budgets) {
            row.declared_us = budget;
        }
        let mut phases: Vec<_> =
            PHASES.iter().enumerate().map(|(at, name)| Row::new(name, graph.nodes.len() + at, times)).collect();
        // A component without a budget has no limit, so its slowest run is added.
        let undeclared = components.iter().filter(|row| row.declared_us.is_none()).map(|row| row.max_us).sum::<f64>();
        let chain = phases.last_mut().expect("the chain");
        chain.declared_us = Some(longest_chain(graph, steps(graph)).sum + undeclared);
        let exceeded = components.iter().chain(&phases).filter_map(Row::exceeded);
        let deadline = phases.last().and_then(|chain| late(chain, graph.budget_ms?));
        let exceeded = exceeded.chain(deadline).collect();
        components.sort_by(|one, other| other.max_us.total_cmp(&one.max_us));
        let (schema, seeds, world) = ("bica/bench/1", seeds.to_vec(), world.to_owned());
        Self { schema, robot: graph.name, world, seeds, deadline_ms: graph.budget_ms, components, phases, exceeded }
    }

    /// Whether another repetition changes no finding: no budget is exceeded, or one is exceeded in more than half of the runs, which
    /// is no interruption.
    pub(super) fn is_settled(&self) -> bool {
        let mut rows = self.components.iter().chain(&self.phases);
        self.exceeded.is_empty() || rows.any(|row| row.declared_us.is_some_and(|declared| row.p50_us > declared))
    }

    /// Names of the components with a budget that never ran.
    pub(super) fn unmeasured(&self) -> impl Iterator<Item = &'static str> {
        self.components.iter().filter(|row| row.declared_us.is_some() && row.runs == 0).map(|row| row.name)
    }
}

/// Message if the slowest chain takes longer than the deadline of the tree.
fn late(chain: &Row, deadline_ms: f32) -> Option<String> {
    let (took, limit) = (1e-3 * chain.max_us, f64::from(deadline_ms));
    (took > limit).then(|| format!("{} takes {took:.2} ms, `budget_ms` is {limit}", chain.name))
}

impl Row {
    fn new(name: &'static str, channel: usize, times: &[Times]) -> Self {
        let mut all: Vec<u32> = times.iter().flat_map(|times| times.of(channel)).collect();
        all.sort_unstable();
        let ever = times.iter().map(|times| times.ever[channel]).max().unwrap_or_default();
        let [p50_us, p99_us, max_us] = [0.5, 0.99, 1.0].map(|part| f64::from(quantile(&all, part)) / 1e3);
        Self { name, runs: all.len(), p50_us, p99_us, max_us, ever_us: f64::from(ever) / 1e3, declared_us: None }
    }

    /// Message if the slowest run exceeds the declared budget.
    pub(super) fn exceeded(&self) -> Option<String> {
        let (Self { name, max_us, .. }, declared) = (self, self.declared_us?);
        let what = format!("{name} takes {max_us:.1} µs in its slowest run and declares {declared} µs");
        (*max_us > declared).then(|| format!("{what}: make it faster, or raise `budget_us`"))
    }
}

/// Quantile of sorted times by the nearest rank, ns; 0 if there are none.
fn quantile(sorted: &[u32], part: f64) -> u32 {
    let rank = (part * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.saturating_sub(1)).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use bica::prelude::*;

    use super::*;

    struct Slow;

    #[component(budget_us = 50)]
    impl Slow {
        const fn new() -> Self {
            Self
        }
    }

    activation_tree! { struct Lamp { root: Slow, cycle_hz: 100, budget_ms: 1, components: [Slow] } }

    /// Figures of one hundred runs, one of which takes `slowest` ns.
    fn figures(slowest: u32) -> Figures {
        figures_of(|at| if at == 9 { slowest } else { 20_000 + at })
    }

    /// Figures of one hundred runs with these times, ns. The chain takes 100 ns more.
    fn figures_of(time: impl Fn(u32) -> u32) -> Figures {
        let times = (0..100).map(time).flat_map(|time| [time, 40, 60, time + 100]).collect();
        let names = ["Slow"].into_iter().chain(PHASES).collect();
        Figures::new(&Lamp::GRAPH, "room", &[0], &[Times::new(names, times)])
    }

    #[test]
    fn slowest_run_within_its_budget_is_no_finding() {
        let figures = figures(49_800);
        assert_eq!(figures.exceeded, <[String; 0]>::default());
        let Row { runs, p50_us, p99_us, max_us, .. } = figures.components[0];
        assert_eq!((runs, p50_us, p99_us, max_us), (100, 20.05, 20.099, 49.8));
    }

    #[test]
    fn component_slower_by_1_ms_is_named() {
        let exceeded = figures(1_020_000).exceeded;
        assert_eq!(exceeded.len(), 3, "{exceeded:?}");
        assert!(exceeded[0].starts_with("Slow takes 1020.0 µs in its slowest run and declares 50 µs"), "{exceeded:?}");
        assert!(exceeded[2].contains("takes 1.02 ms, `budget_ms` is 1"), "{exceeded:?}");
    }

    #[test]
    fn budget_exceeded_in_most_runs_is_settled() {
        assert!(figures(49_800).is_settled(), "no finding");
        assert!(!figures(1_020_000).is_settled(), "one run, which may be an interruption");
        assert!(figures_of(|at| 50_000 + at).is_settled());
    }

    #[test]
    fn budget_without_a_run_is_unmeasured() {
        assert!(Figures::new(&Lamp::GRAPH, "room", &[], &[]).unmeasured().eq(["Slow"]));
        assert_eq!(figures(1).unmeasured().count(), 0);
    }
}
