//! What a run is given.

use crate::body::Body;
use crate::driver::Gait;

/// The robot, and how its run is ended.
pub struct Options {
    /// The robot.
    pub body: &'static Body,
    /// Whose gait walks.
    pub gait: Gait,
    /// Number that differs from that of each other client of the robot.
    pub client: u64,
    /// Longest duration of the run, s.
    pub limit: Option<f64>,
    /// Whether the program was asked to end.
    pub stop: Box<dyn Fn() -> bool + Send>,
    /// Says something to people.
    pub say: fn(&str),
}
