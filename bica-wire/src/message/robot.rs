//! Sensor values and commands.

use bica_motion::joints::JOINTS;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use super::ImageInfo;

/// Sensor values.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Sensors {
    /// Time of measurement, µs.
    pub time_us: u64,
    /// Joint angles in the order of [`bica_motion::joints::Joint`], rad.
    #[serde(deserialize_with = "crate::float_array::deserialize")]
    pub angles: [f32; JOINTS],
    /// Temperatures of the joint motors, °C; NaN: not measured.
    #[serde(deserialize_with = "crate::float_array::deserialize")]
    pub temperatures: [f32; JOINTS],
    /// Currents of the joint motors, A; NaN: not measured.
    #[serde(deserialize_with = "crate::float_array::deserialize")]
    pub currents: [f32; JOINTS],
    /// Angular velocity x, y, z, rad/s; specific force x, y, z, m/s²; roll and pitch, rad.
    #[serde(deserialize_with = "crate::float_array::deserialize")]
    pub inertial: [f32; 8],
    /// Forces on the left foot front left, front right, rear left and rear right, then on the right foot, N.
    #[serde(deserialize_with = "crate::float_array::deserialize")]
    pub feet: [f32; 8],
    /// Chest button, left bumper, right bumper.
    pub buttons: [bool; 3],
    /// The new image, if there is one.
    pub image: Option<ImageInfo>,
}

/// Command for joints, lights and cameras.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Command {
    /// Time of the sensor values from which the command was computed, µs.
    pub time_us: u64,
    /// Target joint angles, rad.
    pub targets: [f32; JOINTS],
    /// Stiffness of each joint, 0 to 1.
    pub stiffness: [f32; JOINTS],
    /// Red, green and blue of the chest, the left eye and the right eye, 0 to 1.
    pub lights: [f32; 9],
    /// Whether the bottom camera is selected.
    pub bottom_camera: bool,
}
