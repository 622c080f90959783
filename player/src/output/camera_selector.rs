//! The selected camera.

use bica::prelude::*;
use bica_motion::robot::CameraId;

/// The camera selection: the robot sends the images of one camera at a time.
#[derive(Debug)]
pub struct CameraSelector {
    camera: CameraId,
}

#[component(budget_us = 1, writers = first)]
impl CameraSelector {
    /// Creates the component with the top camera selected.
    #[must_use]
    pub const fn new() -> Self {
        Self { camera: CameraId::Top }
    }

    /// Selects the camera whose images are sent from now on.
    pub const fn select(&mut self, camera: CameraId) {
        self.camera = camera;
    }

    /// The selected camera.
    #[output]
    #[must_use]
    pub const fn selected(&self) -> CameraId {
        self.camera
    }
}
