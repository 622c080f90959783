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
pub enum GameResult {
    Goal,
    NoGoal,
    Interrupted,
}

/// A game. All but `wall` is the same whenever the same game is played.
#[derive(Clone, Debug, Serialize)]
pub struct Record {
    pub seed: u64,
    pub result: GameResult,
    /// When the goal was made, s.
    pub goal_s: Option<f64>,
    pub own_goals: usize,
    pub falls: usize,
    pub kicks: usize,
    /// Why the robot stopped for good, if it did.
    pub fault: Option<String>,
    /// How long the game was in the world, s.
    pub simulated_s: f64,
    pub cycles: u64,
    /// How often the tree changed.
    pub tree_changes: u64,
    pub fingerprint: String,
    pub events: Vec<Told>,
    pub components: Vec<Component>,
    /// What the microcontroller spent, if one thought.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub firmware: Option<Figures>,
    pub wall: Wall,
    #[serde(skip)]
    pub latencies: Latencies,
}

/// What a component did.
#[derive(Clone, Debug, Serialize)]
pub struct Component {
    pub name: &'static str,
    pub runs: u64,
    /// How long it was active, s.
    pub active_s: f64,
    /// Times that it became active; each brings one run at once.
    pub activations: u64,
    pub declared_hz: f64,
    /// Runs per second in which it was active; none if it never was.
    pub reached_hz: Option<f64>,
}

/// What depends on the computer.
#[derive(Clone, Debug, Serialize)]
pub struct Wall {
    /// How long the game took, s.
    pub real_s: f64,
    /// Sense, think and act of one cycle, ms.
    pub latency_ms: Latency,
    pub components: Vec<Cost>,
}

/// What a component cost.
#[derive(Clone, Debug, Serialize)]
pub struct Cost {
    pub name: &'static str,
    pub total_ms: f64,
    pub mean_us: f64,
    pub budget_us: Option<f32>,
    /// Its part of the time of all components, 0 to 1.
    pub share: f64,
}

/// What happened in a game, counted by whoever played it.
pub struct Tally {
    pub cycles: u64,
    pub tree_changes: u64,
    pub fingerprint: Fingerprint,
    pub latencies: Latencies,
    pub meter: Meter,
}

impl Record {
    /// Sums a game up.
    pub fn new(rules: &Rules, referee: &Referee, played: Duration, tally: Tally, real: Duration) -> Self {
        let goal = referee.events().iter().find(|happened| happened.event == Event::Goal);
        Self {
            seed: rules.seed,
            result: match goal {
                Some(_) => GameResult::Goal,
                None if played >= rules.limit => GameResult::NoGoal,
                None => GameResult::Interrupted,
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
