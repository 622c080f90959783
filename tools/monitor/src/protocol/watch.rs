//! Data of a session that a page watches.

use serde::{Deserialize, Serialize};

/// All data of a session that a page watches.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Watch {
    /// Outputs.
    #[serde(rename = "info")]
    pub outputs: Vec<WatchOutput>,
    /// Components whose conditions of transitions are sent.
    pub conditions: Vec<usize>,
    /// Images, if wanted.
    pub images: Option<WatchImages>,
    /// Whether costs are sent.
    pub costs: bool,
    /// Whether the true state of a simulated world is sent.
    pub truth: bool,
}

/// An output to watch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WatchOutput {
    /// Component.
    pub component: usize,
    /// Output.
    #[serde(rename = "info")]
    pub output: usize,
    /// Interval of the values, cycles: the value of every n-th cycle is sent.
    pub every: u16,
}

/// Images to watch.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WatchImages {
    /// Largest rate, images/s.
    pub max_hz: f32,
}
