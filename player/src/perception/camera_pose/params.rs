//! Parameters of the camera pose.

use bica::prelude::*;
use bica_motion::robot::CameraId;
use bica_vision::projection::Mounting;
use bica_vision::uncertainty::Errors;

/// Corrections of the mounting of both cameras in the head, and of their focal length.
#[derive(Params)]
pub struct CameraMounting {
    /// Rotation of the top camera about its optical axis; positive if it leans to its right.
    #[param(default = 0.0, range = -0.3..=0.3, unit = "rad", step = 0.002)]
    pub(super) top_roll: f32,
    /// Rotation of the top camera downwards.
    #[param(default = 0.0, range = -0.3..=0.3, unit = "rad", step = 0.002)]
    pub(super) top_tilt: f32,
    /// Rotation of the top camera to the left.
    #[param(default = 0.0, range = -0.3..=0.3, unit = "rad", step = 0.002)]
    pub(super) top_pan: f32,
    /// Rotation of the bottom camera about its optical axis; positive if it leans to its right.
    #[param(default = 0.0, range = -0.3..=0.3, unit = "rad", step = 0.002)]
    pub(super) bottom_roll: f32,
    /// Rotation of the bottom camera downwards.
    #[param(default = 0.0, range = -0.3..=0.3, unit = "rad", step = 0.002)]
    pub(super) bottom_tilt: f32,
    /// Rotation of the bottom camera to the left.
    #[param(default = 0.0, range = -0.3..=0.3, unit = "rad", step = 0.002)]
    pub(super) bottom_pan: f32,
    /// Factor on the focal length of both cameras.
    #[param(default = 1.0, range = 0.5..=2.0, step = 0.005)]
    pub(super) focal_scale: f32,
}

impl CameraMounting {
    pub(super) const fn of(&self, camera: CameraId) -> Mounting {
        let focal_scale = self.focal_scale;
        match camera {
            CameraId::Top => Mounting { roll: self.top_roll, tilt: self.top_tilt, pan: self.top_pan, focal_scale },
            CameraId::Bottom => {
                Mounting { roll: self.bottom_roll, tilt: self.bottom_tilt, pan: self.bottom_pan, focal_scale }
            }
        }
    }
}

/// Errors of the camera pose, for all detectors.
#[derive(Params)]
pub struct CameraErrors {
    /// Standard deviation of the camera's pitch and of its roll.
    #[param(default = 0.015, range = 0.001..=0.2, unit = "rad", step = 0.001)]
    pub(super) lean_error: f32,
    /// Standard deviation of the camera's heading.
    #[param(default = 0.015, range = 0.001..=0.2, unit = "rad", step = 0.001)]
    pub(super) pan_error: f32,
    /// Standard deviation of the camera's height.
    #[param(default = 0.008, range = 0.001..=0.1, unit = "m", step = 0.001)]
    pub(super) height_error: f32,
    /// Standard deviation of a pixel's position, each coordinate.
    #[param(default = 1.0, range = 0.1..=10.0, unit = "px", step = 0.1)]
    pub(super) pixel_error: f32,
    /// Rotation between two images above which they may be blurred.
    #[param(default = 0.05, range = 0.0..=1.0, unit = "rad", step = 0.005)]
    pub(super) max_rotation: f32,
}

impl CameraErrors {
    pub(super) const fn errors(&self) -> Errors {
        Errors { lean: self.lean_error, pan: self.pan_error, height: self.height_error, pixels: self.pixel_error }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_exact_mounting_with_nao_s_errors() {
        for camera in [CameraId::Top, CameraId::Bottom] {
            assert_eq!(CameraMounting::DEFAULT.of(camera), Mounting::EXACT);
        }
        assert_eq!(CameraErrors::DEFAULT.errors(), Errors::NAO);
    }
}
