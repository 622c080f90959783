//! The pose of the camera.

use bica::prelude::*;
use bica_vision::projection::Camera;

use super::ego_motion::LastImage;
use crate::Model;
use crate::input::{CameraInput, RobotState};

/// Rotation between two images above which they may be blurred, rad.
const BLURRED: f32 = 0.05;

/// The pose of the camera when it took the newest image, from the joint angles and the support foot.
#[derive(Debug)]
pub struct CameraPose {
    camera: Option<Camera>,
    /// Rotation since the previous image, rad.
    turned: f32,
    image: LastImage,
}

#[component(budget_us = 5)]
impl CameraPose {
    /// Creates the component with an unknown pose.
    #[must_use]
    pub const fn new() -> Self {
        Self { camera: None, turned: 0.0, image: LastImage::new() }
    }

    fn step(&mut self, input: &CameraInput, state: &RobotState) {
        if self.image.take_new(input) {
            let image = input.image();
            let camera = Camera::of::<Model>(image.camera, input.angles(), state.support(), image.width, image.height);
            let [before, now] = [self.camera.unwrap_or(camera), camera].map(|camera| camera.pose().matrix3.x_axis);
            self.turned = now.distance(before);
            self.camera = Some(camera);
        }
    }

    /// Whether the rotation since the previous image is so small that the newest image is sharp.
    #[must_use]
    pub fn is_steady(&self) -> bool {
        self.turned < BLURRED
    }

    /// The camera with its pose in the ground frame; `None` before the first image.
    #[must_use]
    pub const fn camera(&self) -> Option<&Camera> {
        self.camera.as_ref()
    }
}
