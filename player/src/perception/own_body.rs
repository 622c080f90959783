//! The robot's own body in the image.

use bica::prelude::*;
use bica_motion::model::Nao;
use bica_vision::own_body::OwnBody as Body;

use super::CameraPose;
use crate::input::Eye;

/// What the robot's own chest, arms and legs cover in the newest image: what is seen there is no stimulus.
#[derive(Debug)]
pub struct OwnBody {
    body: Body,
    image: u32,
}

#[component(budget_us = 10)]
impl OwnBody {
    /// Covers nothing before the first image.
    #[must_use]
    pub const fn new() -> Self {
        Self { body: Body::NONE, image: 0 }
    }

    fn step(&mut self, eye: &Eye, pose: &CameraPose) {
        if self.image != eye.count() {
            self.image = eye.count();
            let camera = pose.camera();
            self.body = camera.map_or(Body::NONE, |camera| Body::of::<Nao>(camera, eye.image().camera, eye.angles()));
        }
    }

    /// The body in the image.
    #[must_use]
    pub const fn body(&self) -> &Body {
        &self.body
    }
}
