//! The robot's own body in the image.

use bica::prelude::*;
use bica_vision::own_body::OwnBody as Body;

use super::CameraPose;
use super::ego_motion::LastImage;
use crate::input::CameraInput;

/// Shape of the robot's own body.
#[derive(Params)]
pub struct OwnShape {
    /// Thickness added to all parts of the body.
    #[param(default = 0.0, range = -0.05..=0.1, unit = "m", step = 0.005)]
    margin: f32,
}

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

    fn step(&mut self, tuned: &Tuned<OwnShape>, input: &CameraInput, pose: &CameraPose) {
        if self.image.take_new(input) {
            let body =
                |camera| Body::of_mounted(pose.model(), camera, input.image().camera, input.angles(), pose.mounting());
            self.body = pose.camera().map_or(Body::NONE, |camera| body(camera).grown(tuned.margin));
        }
    }

    /// Share of the image that shows the body, 0 to 1.
    #[output]
    fn image_share(&self) -> f32 {
        self.body.image_share()
    }

    /// The body in the image.
    #[must_use]
    pub const fn body(&self) -> &Body {
        &self.body
    }
}
