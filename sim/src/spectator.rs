//! Looking at a world from outside.

use core::fmt;

use glam::{Affine3A, Mat3A, Vec3, Vec3A};

use crate::world::World;

/// How much an onlooker sees from top to bottom, rad (45°).
pub(crate) const FIELD_OF_VIEW: f32 = core::f32::consts::FRAC_PI_4;

/// Where someone looks on from, and to where. Field frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectatorCamera {
    /// The eye.
    pub eye: Vec3,
    /// What is in the middle of the picture; not right above or below the eye.
    pub target: Vec3,
}

/// A picture: rows from the top; red, green and blue of each pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels.
    pub width: usize,
    /// Pixels.
    pub height: usize,
    /// `width * height` of them.
    pub rgb: Vec<[u8; 3]>,
}

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RenderError(pub(crate) String);

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the world cannot be drawn from outside: {}", self.0)
    }
}

impl core::error::Error for RenderError {}

/// A world that others can look at. What they see is the truth: nothing of it may reach a player.
pub trait SpectatorView: World {
    /// What is seen from outside now, as a sharp and even camera of 45° from top to bottom would; width and height in pixels.
    /// Changes nothing in the world.
    ///
    /// # Errors
    ///
    /// If nothing can be drawn; says why.
    fn render_from(&mut self, from: &SpectatorCamera, width: usize, height: usize) -> Result<Picture, RenderError>;
}

impl SpectatorCamera {
    /// The camera's pose in the field frame: x along its axis, y to the left, z up the picture.
    pub(crate) fn pose(&self) -> Affine3A {
        let ahead = Vec3A::from((self.target - self.eye).try_normalize().unwrap_or(Vec3::X));
        let left = Vec3A::Z.cross(ahead).try_normalize().unwrap_or(Vec3A::Y);
        Affine3A { matrix3: Mat3A::from_cols(ahead, left, ahead.cross(left)), translation: self.eye.into() }
    }
}
