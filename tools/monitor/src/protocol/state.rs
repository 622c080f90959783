//! State of a robot at a time, and its course.

use bica::Hold;
use bica_link::Shown;
use bica_wire::message::{ComponentState, LogSource};
use serde::Serialize;

/// State of a component, in JSON a list.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComponentNow(
    /// Whether it was visited in the last cycle.
    pub bool,
    /// How it is held.
    pub Hold,
    /// Index of its state, also of a latent one.
    pub Option<u16>,
    /// Requested rate, Hz; none: every cycle.
    pub Option<f32>,
    /// Time since which it has been in this state, or active or latent, µs.
    pub u64,
);

impl From<ComponentNow> for ComponentState {
    fn from(ComponentNow(active, held, state, hz, _): ComponentNow) -> Self {
        Self { active, held, state, hz }
    }
}

/// A value of information, in JSON a list.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InfoSample(
    /// Component.
    pub usize,
    /// Information.
    pub usize,
    /// Time, µs.
    pub u64,
    /// Value; `null` for `None`.
    pub serde_json::Value,
);

/// The condition of a transition as it was evaluated last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Condition {
    /// Whether it was true; none if it was not evaluated in this state.
    pub holds: Option<bool>,
    /// Time since which it has had this value, µs.
    pub since_us: u64,
    /// Rest of the transition's timer, ms; none without a timer or in another state.
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

/// Time of the components and of the loop.
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
    /// Time of the worst cycle in the window, µs.
    pub worst_us: u64,
}

/// Time of a component, in JSON a list.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComponentCost(
    /// Number of runs in the window.
    pub u32,
    /// Mean time of a run, µs.
    pub f32,
    /// Longest time of a run, µs.
    pub f32,
);

/// A line of the log.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LogLine {
    /// Time, µs.
    pub time_us: u64,
    /// 1 debug, 2 information, 3 warning, 4 error.
    pub level: u8,
    /// Where it comes from.
    pub source: LogSource,
    /// Text.
    pub text: String,
    /// The component that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub component: Option<usize>,
}

/// State at a time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Moment {
    /// Time of the cycle, µs.
    pub time_us: u64,
    /// Number of the cycle.
    pub cycle: u64,
    /// State of each component.
    pub components: Vec<ComponentNow>,
    /// The requested information, as the last sample that is not later.
    pub info: Vec<InfoSample>,
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
    /// Times in which it was active.
    pub bars: Vec<Bar>,
    /// Times of overruns, µs.
    pub overruns: Vec<u64>,
}

/// A time in which a component was active in one state, in JSON a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Bar(
    /// Begin, µs.
    pub u64,
    /// End, µs; of the session if it is active now.
    pub u64,
    /// State; none without states, or if states were merged.
    pub Option<u16>,
);
