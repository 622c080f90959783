//! The camera outside.

use mujoco_rs::prelude::{MjData, MjModel, MjvCamera};
use mujoco_rs::renderer::{MjRenderer, RendererError};

use super::eye::describe;
use crate::film::{NoPicture, Onlooker, Picture};

/// A camera that may be anywhere.
pub(crate) struct Film {
    renderer: MjRenderer,
    width: usize,
    height: usize,
}

impl Film {
    pub(crate) fn new(model: &MjModel, width: usize, height: usize) -> Result<Self, NoPicture> {
        let renderer = MjRenderer::new(model, width, height, 0).map_err(|error| failed(&error))?;
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
        self.renderer.set_camera(camera);
        data.forward_kinematics();
        self.renderer.sync_data(data).and_then(|()| self.renderer.render()).map_err(|error| failed(&error))?;
        let rgb = self.renderer.rgb_flat().map_or(&[][..], |bytes| bytes.as_chunks::<3>().0).to_vec();
        Ok(Picture { width: self.width, height: self.height, rgb })
    }
}

fn failed(error: &RendererError) -> NoPicture {
    NoPicture(describe(error))
}
