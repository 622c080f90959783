//! State of a robot at a time, and over time.

use bica::JobEnd;
use bica_link::Shown;
use bica_wire::message::ComponentState;
use serde::{Serialize, Serializer};

/// State of a component; a list in JSON: active, hold, state, rate, and the time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComponentNow {
    /// The state after the last cycle.
    pub state: ComponentState,
    /// Time of the last change of activation or state, µs.
    pub since_us: u64,
}

impl ComponentNow {
    /// Returns whether the component is active, and its state, also that of a latent one.
    pub(crate) const fn activity(&self) -> (bool, Option<u16>) {
        (self.state.active, self.state.state)
    }
}

impl Serialize for ComponentNow {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ComponentState { active, held, state, hz } = self.state;
        (active, held, state, hz, self.since_us).serialize(serializer)
    }
}

/// A value of an output; a list in JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OutputSample(
    /// Component.
    pub usize,
    /// Output.
    pub usize,
    /// Time, µs.
    pub u64,
    /// Value; `null` for `None`.
    pub serde_json::Value,
);

/// Last evaluation of the condition of a transition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Condition {
    /// Whether the condition held; none if it was not evaluated in this state.
    pub holds: Option<bool>,
    /// Time since which the condition has had this value, µs.
    pub since_us: u64,
    /// Remaining time of the transition's timer, ms; none without a timer or in another state.
    pub remaining_ms: Option<u32>,
}

/// Conditions of the transitions of a component.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Conditions {
    /// Component.
    pub component: usize,
    /// Time, µs.
    pub time_us: u64,
    /// One for each transition of the component.
    pub conditions: Vec<Condition>,
}

/// Execution times of the components and of the loop.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Costs {
    /// Time, µs.
    pub time_us: u64,
    /// Time since the last costs, µs.
    pub window_us: u64,
    /// One for each component.
    pub components: Vec<ComponentCost>,
    /// Mean and largest duration of a cycle from sensor values to command, µs.
    pub chain_us: (f32, f32),
    /// Time at which the longest cycle of the window took place, µs.
    pub worst_us: u64,
}

/// Execution time of a component; a list in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComponentCost(
    /// Number of runs in the window.
    pub u32,
    /// Mean time of a run, µs.
    pub f32,
    /// Longest time of a run, µs.
    pub f32,
);

/// State at a time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Moment {
    /// Time of the cycle, µs.
    pub time_us: u64,
    /// Number of the cycle.
    pub cycle: u64,
    /// State of each component.
    pub components: Vec<ComponentNow>,
    /// The requested outputs: of each the last sample that is not later.
    #[serde(rename = "info")]
    pub outputs: Vec<OutputSample>,
    /// Number of the image, if there is one.
    pub image: Option<u32>,
    /// True state, if it is known.
    pub truth: Option<Vec<Shown>>,
    /// Conditions of the components whose conditions the page watches, as far as they are known.
    pub conditions: Vec<Conditions>,
    /// The last costs that are not later, if they are known.
    pub costs: Option<Costs>,
}

/// Activity of a component in an interval.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Component.
    pub component: usize,
    /// Intervals in which the component was active.
    pub bars: Vec<Bar>,
    /// Times of overruns, µs.
    pub overruns: Vec<u64>,
    /// Jobs beside the loop.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub jobs: Vec<Job>,
}

/// A job of a component; a list in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Job(
    /// Begin, µs.
    pub u64,
    /// Due time, µs.
    pub u64,
    /// End, µs; none if it is in progress, or was dropped and no other one was begun.
    pub Option<u64>,
    /// How it ended; none if it was dropped or is in progress.
    pub Option<JobEnd>,
);

/// An interval in which a component was active in one state; a list in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Bar(
    /// Begin, µs, not before the requested interval.
    pub u64,
    /// End, µs, not after the requested interval and the last cycle.
    pub u64,
    /// State; none without states, or if states were merged.
    pub Option<u16>,
);
