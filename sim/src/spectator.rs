//! Views of a world from a camera outside the robot.

use core::fmt;

use glam::{Affine3A, Mat3A, Vec3, Vec3A};

use crate::world::World;

/// Vertical field of view of a spectator camera, rad (45°).
pub(crate) const FIELD_OF_VIEW: f32 = core::f32::consts::FRAC_PI_4;

/// Position and direction of a camera that shows the world to people. Field frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectatorCamera {
    /// Optical centre.
    pub eye: Vec3,
    /// Point in the centre of the picture; must not lie straight above or below `eye`.
    pub target: Vec3,
}

/// An RGB picture, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width, pixels.
    pub width: usize,
    /// Height, pixels.
    pub height: usize,
    /// Red, green and blue of `width * height` pixels.
    pub rgb: Vec<[u8; 3]>,
}

/// The reason why a view could not be rendered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RenderError(pub(crate) String);

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the spectator view cannot be rendered: {}", self.0)
    }
}

impl core::error::Error for RenderError {}

/// A world that can be rendered from outside. The view shows ground truth: the robot's program must not use it.
pub trait SpectatorView: World {
    /// Renders the current state as an ideal camera with a vertical field of view of 45° shows it; width and height in
    /// pixels. Does not change the state of the world.
    ///
    /// # Errors
    ///
    /// If no renderer is available; the error contains the reason.
    fn render_from(&mut self, camera: &SpectatorCamera, width: usize, height: usize) -> Result<Picture, RenderError>;
}

impl SpectatorCamera {
    /// Returns the camera's pose in the field frame: x along the optical axis, y to the left, z up in the picture.
    pub(crate) fn pose(&self) -> Affine3A {
        let ahead = Vec3A::from((self.target - self.eye).try_normalize().unwrap_or(Vec3::X));
        let left = Vec3A::Z.cross(ahead).try_normalize().unwrap_or(Vec3A::Y);
        Affine3A { matrix3: Mat3A::from_cols(ahead, left, ahead.cross(left)), translation: self.eye.into() }
    }
}
