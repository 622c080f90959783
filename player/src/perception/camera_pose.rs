//! Where the camera is.

use bica::prelude::*;
use bica_vision::projection::Camera;

use crate::input::{Eye, Measured};

/// The camera over the ground at the moment of the newest image, from the joints and the foot that carries.
#[derive(Debug)]
pub struct CameraPose {
    camera: Option<Camera>,
    image: u32,
}

#[component(budget_us = 5)]
impl CameraPose {
    /// Knows nothing before the first image.
    #[must_use]
    pub const fn new() -> Self {
        Self { camera: None, image: 0 }
    }

    fn step(&mut self, eye: &Eye, body: &Measured) {
        if self.image != eye.count() {
            self.image = eye.count();
            let image = eye.image();
            self.camera = Some(Camera::of_nao(image.camera, eye.angles(), body.support(), image.width, image.height));
        }
    }

    /// The camera, in the ground frame; none before the first image.
    #[must_use]
    pub const fn camera(&self) -> Option<&Camera> {
        self.camera.as_ref()
    }
}
