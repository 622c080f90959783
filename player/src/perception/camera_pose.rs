//! Where the camera is.

use bica::prelude::*;
use bica_motion::model::Nao;
use bica_vision::projection::Camera;

use crate::input::{Eye, Measured};

/// A camera that turns farther than this between two images, rad, may blur what it shows.
const BLURRED: f32 = 0.05;

/// The camera over the ground at the moment of the newest image, from the joints and the foot that carries.
#[derive(Debug)]
pub struct CameraPose {
    camera: Option<Camera>,
    turned: f32,
    image: u32,
}

#[component(budget_us = 5)]
impl CameraPose {
    /// Knows nothing before the first image.
    #[must_use]
    pub const fn new() -> Self {
        Self { camera: None, turned: 0.0, image: 0 }
    }

    fn step(&mut self, eye: &Eye, body: &Measured) {
        if self.image != eye.count() {
            self.image = eye.count();
            let image = eye.image();
            let camera = Camera::of::<Nao>(image.camera, eye.angles(), body.support(), image.width, image.height);
            let [before, now] = [self.camera.unwrap_or(camera), camera].map(|camera| camera.pose().matrix3.x_axis);
            self.turned = now.distance(before);
            self.camera = Some(camera);
        }
    }

    /// Whether the camera held still enough for a sharp image, since the one before.
    #[must_use]
    pub fn is_steady(&self) -> bool {
        self.turned < BLURRED
    }

    /// The camera, in the ground frame; none before the first image.
    #[must_use]
    pub const fn camera(&self) -> Option<&Camera> {
        self.camera.as_ref()
    }
}
