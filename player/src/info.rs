//! Types of published outputs.
//!
//! With the feature `info` they can be serialised. glam's types cannot, because they have no postcard schema.

use bica_motion::pose::Pose2;
use glam::Vec2;

/// Point or vector: on the ground, x forward and y left, or in an image, x right and y down. The getter states the frame
/// and the unit.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub struct Point {
    /// First coordinate.
    pub x: f32,
    /// Second coordinate.
    pub y: f32,
}

impl From<Vec2> for Point {
    fn from(Vec2 { x, y }: Vec2) -> Self {
        Self { x, y }
    }
}

/// Pose on the ground; the getter states the frame.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub struct Pose {
    /// Position along x, m.
    pub x: f32,
    /// Position along y, m.
    pub y: f32,
    /// Heading, rad, counter-clockwise from x.
    pub heading: f32,
}

impl From<Pose2> for Pose {
    fn from(Pose2 { position: Vec2 { x, y }, heading }: Pose2) -> Self {
        Self { x, y, heading }
    }
}
