//! In the image of a camera: x right, y down, px.

use super::List;

/// Point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct ImagePoint {
    /// Column.
    pub x: f32,
    /// Row.
    pub y: f32,
}

/// Circle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct ImageCircle {
    /// Column of the centre.
    pub x: f32,
    /// Row of the centre.
    pub y: f32,
    /// Radius.
    pub radius: f32,
}

/// Line segment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct ImageSegment {
    /// One end.
    pub start: ImagePoint,
    /// The other end.
    pub end: ImagePoint,
}

/// Points joined by lines.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct ImagePolyline<const N: usize> {
    /// The points in order.
    pub points: List<ImagePoint, N>,
}

/// Intrinsic parameters of a camera: its frame looks along x, with y left and z up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct CameraCalibration {
    /// Focal length, in columns.
    pub focal_x: f32,
    /// Focal length, in rows.
    pub focal_y: f32,
    /// Column of the optical axis.
    pub centre_x: f32,
    /// Row of the optical axis.
    pub centre_y: f32,
}
