//! What is left of a game when it is over.

use std::time::Duration;

use bica::graph::{Graph, Node};
use bica_sim::Referee;
use bica_sim::referee::Event;
use serde::Serialize;

use super::event::Told;
use super::fingerprint::Fingerprint;
use super::firmware::Figures;
use super::game_loop::Rules;
use super::latency::{Latencies, Latency};
use super::meter::{Meter, Work};
use super::scene::GRAPH;

/// How a game ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Outcome {
    Goal,
    NoGoal,
    Interrupted,
}

/// A game. All but `wall` is the same whenever the same game is played.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Record {
    pub(crate) seed: u64,
    pub(crate) result: Outcome,
    /// When the goal was made, s.
    pub(crate) goal_s: Option<f64>,
    pub(crate) own_goals: usize,
    pub(crate) falls: usize,
    pub(crate) kicks: usize,
    /// Why the robot stopped for good, if it did.
    pub(crate) fault: Option<String>,
    /// How long the game was in the world, s.
    pub(crate) simulated_s: f64,
    pub(crate) cycles: u64,
    /// How often the tree changed.
    pub(crate) tree_changes: u64,
    pub(crate) fingerprint: String,
    pub(crate) events: Vec<Told>,
    pub(crate) components: Vec<Component>,
    /// What the microcontroller spent, if one thought.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) firmware: Option<Figures>,
    pub(crate) wall: Wall,
    #[serde(skip)]
    pub(crate) latencies: Latencies,
}

/// What a component did.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Component {
    pub(crate) name: &'static str,
    pub(crate) runs: u64,
    /// How long it was active, s.
    pub(crate) active_s: f64,
    /// Times that it became active; each brings one run at once.
    pub(crate) activations: u64,
    pub(crate) declared_hz: f64,
    /// Runs per second in which it was active; none if it never was.
    pub(crate) reached_hz: Option<f64>,
}

/// What depends on the computer.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Wall {
    /// How long the game took, s.
    pub(crate) real_s: f64,
    /// Sense, think and act of one cycle, ms.
    pub(crate) latency_ms: Latency,
    pub(crate) components: Vec<Cost>,
}

/// What a component cost.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Cost {
    pub(crate) name: &'static str,
    pub(crate) total_ms: f64,
    pub(crate) mean_us: f64,
    pub(crate) budget_us: Option<f32>,
    /// Its part of the time of all components, 0 to 1.
    pub(crate) share: f64,
}

/// What happened in a game, counted by whoever played it.
pub(crate) struct Tally {
    pub(crate) cycles: u64,
    pub(crate) tree_changes: u64,
    pub(crate) fingerprint: Fingerprint,
    pub(crate) latencies: Latencies,
    pub(crate) meter: Meter,
}

impl Record {
    /// Sums a game up.
    pub(crate) fn new(rules: &Rules, referee: &Referee, played: Duration, tally: Tally, real: Duration) -> Self {
        let goal = referee.events().iter().find(|happened| happened.event == Event::Goal);
        Self {
            seed: rules.seed,
            result: match goal {
                Some(_) => Outcome::Goal,
                None if played >= rules.limit => Outcome::NoGoal,
                None => Outcome::Interrupted,
            },
            goal_s: goal.map(|happened| happened.at.as_secs_f64()),
            own_goals: referee.own_goals(),
            falls: referee.falls(),
            kicks: referee.count(|event| matches!(event, Event::Kick { .. })),
            fault: None,
            simulated_s: played.as_secs_f64(),
            cycles: tally.cycles,
            tree_changes: tally.tree_changes,
            fingerprint: tally.fingerprint.to_string(),
            events: referee.events().iter().map(Told::from).collect(),
            components: components(&GRAPH, &tally.meter),
            firmware: None,
            wall: Wall {
                real_s: real.as_secs_f64(),
                latency_ms: tally.latencies.sum_up(),
                components: costs(&GRAPH, &tally.meter),
            },
            latencies: tally.latencies,
        }
    }
}

/// What each component did, by the probe.
fn components(graph: &Graph, meter: &Meter) -> Vec<Component> {
    let cycle = 1.0 / f64::from(graph.cycle_hz);
    let describe = |(node, work): (&Node, &Work)| {
        let active_s = work.active as f64 * cycle;
        Component {
            name: node.name,
            runs: work.runs,
            active_s,
            activations: work.starts,
            declared_hz: f64::from(node.hz.unwrap_or(graph.cycle_hz)),
            reached_hz: (work.active > 0).then(|| work.runs as f64 / active_s),
        }
    };
    graph.nodes.iter().zip(&meter.work).map(describe).collect()
}

/// What each component cost, by the probe.
fn costs(graph: &Graph, meter: &Meter) -> Vec<Cost> {
    let all: f64 = meter.work.iter().map(|work| work.time.as_secs_f64()).sum();
    let describe = |(node, work): (&Node, &Work)| {
        let time = work.time.as_secs_f64();
        Cost {
            name: node.name,
            total_ms: 1e3 * time,
            mean_us: 1e6 * time / work.runs.max(1) as f64,
            budget_us: node.budget_us,
            share: if all > 0.0 { time / all } else { 0.0 },
        }
    };
    graph.nodes.iter().zip(&meter.work).map(describe).collect()
}
