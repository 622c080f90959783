//! Range of a joint.

use crate::bounds::clamp;

/// Closed range of a joint's angle: rad; a hand: 0 (closed) to 1 (open).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower limit.
    pub min: f32,
    /// Upper limit.
    pub max: f32,
}

impl Range {
    /// A range from limits in degrees.
    #[must_use]
    pub const fn degrees(min: f32, max: f32) -> Self {
        Self { min: min.to_radians(), max: max.to_radians() }
    }

    /// Nearest value in the range; NaN counts as 0.
    #[must_use]
    pub fn clamp(&self, angle: f32) -> f32 {
        clamp(if angle.is_nan() { 0.0 } else { angle }, self.min, self.max)
    }

    /// Whether `angle` lies in the range.
    #[must_use]
    pub fn contains(&self, angle: f32) -> bool {
        (self.min..=self.max).contains(&angle)
    }
}
