//! Distances around a sensor.

use super::List;

/// Distances that a lidar measured.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "output", derive(serde::Serialize, postcard_schema::Schema))]
pub struct Scan<const N: usize> {
    /// Angle of the first ray, rad, counter-clockwise from x.
    pub angle_min: f32,
    /// Angle between two rays, rad.
    pub angle_increment: f32,
    /// Longest distance that is measured, m; a ray without an end has a longer or no finite one.
    pub range_max: f32,
    /// Distances, m.
    pub ranges: List<f32, N>,
}
