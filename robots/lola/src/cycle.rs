//! What the driver and the robot program exchange.

use bica_camera::Frame;
use bica_motion::robot::Command;

use crate::ending::Reason;
use crate::sensor_map::SensorMap;

/// A cycle of the robot program.
#[derive(Default)]
pub(crate) struct Cycle {
    pub(crate) map: SensorMap,
    /// Number of valid maps, with this one.
    pub(crate) maps: u64,
    /// A new image of the selected camera.
    pub(crate) image: Option<Frame>,
    /// Number of the cycle since the robot program was asked to end its motion.
    pub(crate) halt: Option<u32>,
}

/// The command of the robot program to its last cycle, or why it ends.
pub(crate) type Message = Result<Command, Reason>;
