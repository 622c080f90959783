//! Light in the hall: lamps above, brighter from one side.

use core::f32::consts::PI;

use glam::Vec3;
use libm::{cosf, sinf};

use crate::random::Random;

/// How surfaces are lit. 256 is a surface that the palette's colours were chosen for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Light {
    /// Where the brighter side is, unit vector.
    pub(crate) from: Vec3,
    /// How the brightness of the ground changes over the field, 1/m.
    pub(crate) slope: (f32, f32),
}

impl Light {
    pub(crate) fn new(random: &mut Random) -> Self {
        let azimuth = random.between(-PI, PI);
        let from = Vec3::new(cosf(azimuth), sinf(azimuth), 0.6).normalize();
        let slope = random.between(0.0, 0.035);
        Self { from, slope: (slope * from.x, slope * from.y) }
    }

    /// How bright a surface with this outward unit normal (field frame) is.
    pub(crate) fn on(&self, normal: Vec3) -> i32 {
        let above = 0.5 + 0.5 * normal.z;
        let side = normal.dot(self.from).max(0.0);
        (256.0 * (0.66 + 0.26 * above + 0.22 * side)) as i32
    }
}
