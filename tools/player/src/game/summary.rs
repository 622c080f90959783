//! Summary of a game.

use std::time::Duration;

use bica::graph::{Graph, Node};
use bica_link::ComponentTime;
use bica_sim::Referee;
use bica_sim::referee::Event;
use serde::Serialize;

use crate::game::event::EventRecord;
use crate::game::fingerprint::Fingerprint;
use crate::game::firmware::FirmwareSummary;
use crate::game::latency::{Latencies, LatencySummary};
use crate::game::meter::{Activity, Meter};
use crate::game::rules::Rules;
use crate::game::scene::GRAPH;

/// Result of a game.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum GameResult {
    /// The robot scored.
    Goal,
    /// The time was over without a goal.
    NoGoal,
    /// Ctrl-C.
    Interrupted,
}

/// Summary of a game. It is reproducible except for `wall`.
#[derive(Clone, Debug, Serialize)]
pub struct GameSummary {
    /// Seed.
    pub seed: u64,
    /// Result.
    pub result: GameResult,
    /// Time of the goal, s.
    pub goal_s: Option<f64>,
    /// Number of own goals.
    pub own_goals: usize,
    /// Number of falls.
    pub falls: usize,
    /// Number of kicks.
    pub kicks: usize,
    /// Fault that stopped the robot or the world at the end.
    pub fault: Option<String>,
    /// Begin and end of each fault.
    pub faults: Vec<FaultRecord>,
    /// Duration in simulated time, s.
    pub simulated_s: f64,
    /// Number of control cycles.
    pub cycles: u64,
    /// Number of cycles that changed the tree.
    pub tree_changes: u64,
    /// Fingerprint over commands and ball positions.
    pub fingerprint: String,
    /// Events of the referee.
    pub events: Vec<EventRecord>,
    /// Activity of each component.
    pub components: Vec<ComponentActivity>,
    /// Instructions of the firmware, if it controlled the robot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub firmware: Option<FirmwareSummary>,
    /// Values that depend on the computer.
    pub wall: Wall,
    #[serde(skip)]
    pub(crate) latencies: Latencies,
}

/// Beginning or end of a fault.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FaultRecord {
    /// Time, s.
    pub t: f64,
    /// The fault; `None` if it has ended.
    pub fault: Option<String>,
}

impl FaultRecord {
    /// Text of the record, one line.
    pub(crate) fn text(&self) -> String {
        self.fault.as_ref().map_or_else(|| "the fault is over".to_owned(), |fault| format!("fault: {fault}"))
    }
}

/// Activity of a component.
#[derive(Clone, Debug, Serialize)]
pub struct ComponentActivity {
    /// Name.
    pub name: &'static str,
    /// Number of runs.
    pub runs: u64,
    /// Time in which it was active, s.
    pub active_s: f64,
    /// Number of activations; each causes one immediate run.
    pub activations: u64,
    /// Declared rate, Hz.
    pub declared_hz: f64,
    /// Runs per second of active time; `None` if it was never active.
    pub reached_hz: Option<f64>,
}

/// Values that depend on the computer.
#[derive(Clone, Debug, Serialize)]
pub struct Wall {
    /// Duration in real time, s.
    pub real_s: f64,
    /// Latency of a cycle, ms.
    pub latency_ms: LatencySummary,
    /// Cost of each component.
    pub components: Vec<ComponentCost>,
}

/// Cost of a component.
#[derive(Clone, Debug, Serialize)]
pub struct ComponentCost {
    /// Name.
    pub name: &'static str,
    /// Total time, ms.
    pub total_ms: f64,
    /// Mean time of a run, µs.
    pub mean_us: f64,
    /// Declared budget of a run, µs.
    pub budget_us: Option<f32>,
    /// Share of the time of all components, 0 to 1.
    pub share: f64,
}

/// Measurements of a game.
pub(crate) struct Measurements {
    pub(crate) cycles: u64,
    pub(crate) tree_changes: u64,
    pub(crate) fingerprint: Fingerprint,
    pub(crate) latencies: Latencies,
    pub(crate) meter: Meter,
}

impl GameSummary {
    /// Creates the summary of a game that took `played` in simulated time and `real` in real time.
    pub(crate) fn new(
        rules: &Rules,
        referee: &Referee,
        played: Duration,
        measured: Measurements,
        real: Duration,
    ) -> Self {
        let goal = referee.events().iter().find(|event| event.event == Event::Goal);
        Self {
            seed: rules.seed,
            result: match goal {
                Some(_) => GameResult::Goal,
                None if played >= rules.limit => GameResult::NoGoal,
                None => GameResult::Interrupted,
            },
            goal_s: goal.map(|event| event.at.as_secs_f64()),
            own_goals: referee.own_goals(),
            falls: referee.falls(),
            kicks: referee.count(|event| matches!(event, Event::Kick { .. })),
            fault: None,
            faults: Vec::new(),
            simulated_s: played.as_secs_f64(),
            cycles: measured.cycles,
            tree_changes: measured.tree_changes,
            fingerprint: measured.fingerprint.to_string(),
            events: referee.events().iter().map(EventRecord::from).collect(),
            components: activities(&GRAPH, &measured.meter),
            firmware: None,
            wall: Wall {
                real_s: real.as_secs_f64(),
                latency_ms: measured.latencies.summarize(),
                components: costs(&GRAPH, &measured.meter),
            },
            latencies: measured.latencies,
        }
    }
}

/// Returns the activity of each component.
fn activities(graph: &Graph, meter: &Meter) -> Vec<ComponentActivity> {
    let cycle = 1.0 / f64::from(graph.cycle_hz);
    let describe = |((node, activity), time): ((&Node, &Activity), &ComponentTime)| {
        let active_s = activity.active as f64 * cycle;
        ComponentActivity {
            name: node.name,
            runs: time.runs.into(),
            active_s,
            activations: activity.starts,
            declared_hz: f64::from(node.hz.unwrap_or(graph.cycle_hz)),
            reached_hz: (activity.active > 0).then(|| f64::from(time.runs) / active_s),
        }
    };
    graph.nodes.iter().zip(&meter.activity).zip(meter.costs.components()).map(describe).collect()
}

/// Returns the cost of each component.
fn costs(graph: &Graph, meter: &Meter) -> Vec<ComponentCost> {
    let all: f64 = meter.costs.components().iter().map(|component| component.total.as_secs_f64()).sum();
    let describe = |(node, component): (&Node, &ComponentTime)| {
        let time = component.total.as_secs_f64();
        ComponentCost {
            name: node.name,
            total_ms: 1e3 * time,
            mean_us: 1e6 * time / f64::from(component.runs.max(1)),
            budget_us: node.budget_us,
            share: if all > 0.0 { time / all } else { 0.0 },
        }
    };
    graph.nodes.iter().zip(meter.costs.components()).map(describe).collect()
}
