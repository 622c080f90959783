//! What a run is given.

use std::process::Command;

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
    /// Command of a process that runs [`guard()`](crate::guard()): it gives the robot to its firmware if this process is killed. `None`: a
    /// killed process leaves the robot as it is.
    pub guard: Option<Command>,
    /// Called after a run that ended because its program hangs: nobody else can end this process.
    pub abandon: fn(),
    /// Whether the program was asked to end.
    pub stop: Box<dyn Fn() -> bool + Send>,
    /// Says something to people.
    pub say: fn(&str),
}
