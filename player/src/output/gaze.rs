//! Which camera looks.

use bica::prelude::*;
use bica_motion::robot::CameraId;

/// The camera selection: the robot sends the images of one camera at a time.
#[derive(Debug)]
pub struct Gaze {
    camera: CameraId,
}

#[component(budget_us = 1)]
impl Gaze {
    /// Looks through the top camera.
    #[must_use]
    pub const fn new() -> Self {
        Self { camera: CameraId::Top }
    }

    /// Asks for images of `camera` from now on.
    pub const fn through(&mut self, camera: CameraId) {
        self.camera = camera;
    }

    /// The camera that was asked for.
    #[must_use]
    pub const fn camera(&self) -> CameraId {
        self.camera
    }
}
