//! The camera outside.

use mujoco_rs::prelude::{MjData, MjModel, MjvCamera};
use mujoco_rs::renderer::RendererError;

use super::eye::describe;
use super::model::ONLOOKERS;
use super::renderer::Renderer;
use crate::film::{NoPicture, Onlooker, Picture};

/// A camera that may be anywhere.
pub(crate) struct Film {
    renderer: Renderer,
    width: usize,
    height: usize,
}

impl Film {
    pub(crate) fn new(model: &MjModel, width: usize, height: usize) -> Result<Self, NoPicture> {
        let mut renderer = Renderer::new(model, width, height).map_err(|error| failed(&error))?;
        renderer.show(ONLOOKERS);
        Ok(Self { renderer, width, height })
    }

    /// Width and height of pictures, pixels.
    pub(crate) const fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    pub(crate) fn take(&mut self, data: &mut MjData<Box<MjModel>>, from: &Onlooker) -> Result<Picture, NoPicture> {
        let way = from.target - from.eye;
        let (up, along) = (way.z, way.truncate());
        let mut camera = MjvCamera::new_free(data.model());
        camera.lookat = from.target.to_array().map(f64::from);
        camera.distance = way.length().into();
        camera.azimuth = along.y.atan2(along.x).to_degrees().into();
        camera.elevation = up.atan2(along.length()).to_degrees().into();
        let rgb = self.renderer.draw(data, camera).map_err(|error| failed(&error))?.to_vec();
        Ok(Picture { width: self.width, height: self.height, rgb })
    }
}

fn failed(error: &RendererError) -> NoPicture {
    NoPicture(describe(error))
}
