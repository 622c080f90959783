//! Sensor values and commands.

use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use super::BlobsInfo;

/// Sensor values of the robot's own type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Sensors<'a> {
    /// Time of measurement, µs.
    pub time_us: u64,
    /// The large data in the values; none without any. Its chunks were sent before.
    pub blobs: Option<BlobsInfo>,
    /// The values without their large data, as [`blobs`](crate::blobs) encodes them.
    pub values: &'a [u8],
}

/// Command of the robot's own type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Command<'a> {
    /// Time of the sensor values from which the command was computed, µs.
    pub time_us: u64,
    /// The command in postcard's format.
    pub values: &'a [u8],
}
