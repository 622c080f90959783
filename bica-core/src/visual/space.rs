//! In space: x forward, y left, z up.

/// Point or vector.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Point3 {
    /// First coordinate, m unless the getter states another unit.
    pub x: f32,
    /// Second coordinate.
    pub y: f32,
    /// Third coordinate.
    pub z: f32,
}

/// Rotation, a unit quaternion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Quaternion {
    /// Component of i.
    pub x: f32,
    /// Component of j.
    pub y: f32,
    /// Component of k.
    pub z: f32,
    /// Real component.
    pub w: f32,
}

/// Pose.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Pose3 {
    /// Position, m.
    pub position: Point3,
    /// Rotation from the child's axes to those of the frame.
    pub orientation: Quaternion,
}
