//! On the ground: x forward, y left.

use super::List;

/// Point or vector.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Point2 {
    /// First coordinate, m unless the getter states another unit.
    pub x: f32,
    /// Second coordinate.
    pub y: f32,
}

/// Pose.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Pose2 {
    /// Position along x, m.
    pub x: f32,
    /// Position along y, m.
    pub y: f32,
    /// Heading, rad, counter-clockwise from x.
    pub heading: f32,
}

/// Uncertain point: its covariance is drawn as the ellipse of one standard deviation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Ellipse {
    /// Position along x, m.
    pub x: f32,
    /// Position along y, m.
    pub y: f32,
    /// Variance of x, m².
    pub xx: f32,
    /// Covariance of x and y, m².
    pub xy: f32,
    /// Variance of y, m².
    pub yy: f32,
}

/// Uncertain pose: drawn as a pose with the ellipse of one standard deviation of its position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct PoseWithCovariance2 {
    /// Position along x, m.
    pub x: f32,
    /// Position along y, m.
    pub y: f32,
    /// Heading, rad, counter-clockwise from x.
    pub heading: f32,
    /// Variance of x, m².
    pub xx: f32,
    /// Covariance of x and y, m².
    pub xy: f32,
    /// Covariance of x and the heading, m·rad.
    pub xh: f32,
    /// Variance of y, m².
    pub yy: f32,
    /// Covariance of y and the heading, m·rad.
    pub yh: f32,
    /// Variance of the heading, rad².
    pub hh: f32,
}

/// Circle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Circle {
    /// Position of the centre along x, m.
    pub x: f32,
    /// Position of the centre along y, m.
    pub y: f32,
    /// Radius, m.
    pub radius: f32,
}

/// Rectangle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Rectangle {
    /// Position of the centre along x, m.
    pub x: f32,
    /// Position of the centre along y, m.
    pub y: f32,
    /// Direction of the length, rad, counter-clockwise from x.
    pub heading: f32,
    /// Length, m.
    pub length: f32,
    /// Width, m.
    pub width: f32,
}

/// Line segment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Segment {
    /// One end.
    pub start: Point2,
    /// The other end.
    pub end: Point2,
}

/// Points joined by lines, such as a path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Polyline<const N: usize> {
    /// The points in order.
    pub points: List<Point2, N>,
}
