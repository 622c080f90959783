//! Illumination of the hall: lamps above, brighter from one side.

use core::f32::consts::PI;

use glam::Vec3;
use libm::{cosf, sinf};

use crate::random::Random;

/// Illumination of surfaces; brightness 256 leaves the palette's colours unchanged.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Light {
    /// Direction of the brighter side, unit vector, field frame.
    pub(crate) from: Vec3,
    /// Relative change of the brightness of the ground along x and y, 1/m.
    pub(crate) slope: (f32, f32),
}

impl Light {
    pub(crate) fn new(random: &mut Random) -> Self {
        let azimuth = random.between(-PI, PI);
        let from = Vec3::new(cosf(azimuth), sinf(azimuth), 0.6).normalize();
        let slope = random.between(0.0, 0.035);
        Self { from, slope: (slope * from.x, slope * from.y) }
    }

    /// Returns the brightness, of 256, of a surface with this outward unit normal (field frame).
    pub(crate) fn on(&self, normal: Vec3) -> i32 {
        let above = 0.5 + 0.5 * normal.z;
        let side = normal.dot(self.from).max(0.0);
        (256.0 * (0.66 + 0.26 * above + 0.22 * side)) as i32
    }
}
