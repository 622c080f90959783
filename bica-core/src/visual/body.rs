//! What a robot measures of its own body. Nothing is drawn; the types have standard messages in ROS.

use super::{Point3, Quaternion};

/// Positions of joints: arrays, or [`List`](super::List)s, of names and of numbers. A name is a value of an enum, or a text.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Joints<Names, Positions> {
    /// The joints.
    pub names: Names,
    /// Position of each joint, rad, or m of a joint that slides.
    pub positions: Positions,
}

/// Values of an inertial unit, along the axes of its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Imu {
    /// Turn rate, rad/s.
    pub angular_velocity: Point3,
    /// Acceleration with that of gravity, which is upward at rest, m/s².
    pub linear_acceleration: Point3,
    /// Rotation from the axes of the frame to those of the world; `None` if it is not estimated.
    pub orientation: Option<Quaternion>,
}
