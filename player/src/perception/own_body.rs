//! The robot's own body in the image.

use bica::prelude::*;
use bica_vision::own_body::OwnBody as Body;

use super::CameraPose;
use super::ego_motion::LastImage;
use crate::Model;
use crate::input::CameraInput;

/// Part of the newest image that the robot's own chest, arms and legs cover. Detectors ignore it.
#[derive(Debug)]
pub struct OwnBody {
    body: Body,
    image: LastImage,
}

#[component(budget_us = 10)]
impl OwnBody {
    /// Creates the component with nothing covered.
    #[must_use]
    pub const fn new() -> Self {
        Self { body: Body::NONE, image: LastImage::new() }
    }

    fn step(&mut self, input: &CameraInput, pose: &CameraPose) {
        if self.image.take_new(input) {
            let camera = pose.camera();
            self.body =
                camera.map_or(Body::NONE, |camera| Body::of::<Model>(camera, input.image().camera, input.angles()));
        }
    }

    /// The body in the image.
    #[must_use]
    pub const fn body(&self) -> &Body {
        &self.body
    }
}
