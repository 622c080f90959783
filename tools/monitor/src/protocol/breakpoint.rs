//! Breakpoints on states and transitions.

use serde::{Deserialize, Serialize};

use super::SessionId;

/// A breakpoint: a component with either a state or a transition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Breakpoint {
    /// Component.
    pub component: usize,
    /// State. The breakpoint is reached in the first cycle in which the component is active in this state.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub state: Option<usize>,
    /// Transition. The breakpoint is reached in the cycle in which the transition is taken. A session that does not send the values
    /// of conditions (a recording, a microcontroller) shows only states: there, every transition between the same two states
    /// reaches the breakpoint, and a transition from a state to itself can have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub transition: Option<usize>,
}

/// A breakpoint that was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Reached {
    /// Time of the cycle, µs.
    pub time_us: u64,
    /// The breakpoint.
    #[serde(flatten)]
    pub breakpoint: Breakpoint,
}

/// A breakpoint that was reached in a live session.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Hit {
    /// Session.
    pub session: SessionId,
    /// Time and breakpoint.
    #[serde(flatten)]
    pub reached: Reached,
    /// Whether the world was paused. A robot is never stopped.
    pub paused: bool,
}
