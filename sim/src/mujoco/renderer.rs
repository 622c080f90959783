//! Off-screen rendering from any thread.

use std::sync::{Mutex, PoisonError};

use mujoco_rs::prelude::{MjData, MjModel, MjvCamera};
use mujoco_rs::renderer::{MjRenderer, RendererError};

/// Held while a renderer is created, draws or is dropped: all renderers share one display, which is not thread-safe.
///
/// Mesa's software renderer (22.3) looks for a texture in the unfinished scenes of *all* contexts of a display, without a
/// lock: two threads that draw at the same time read freed memory.
static DISPLAY: Mutex<()> = Mutex::new(());

/// An off-screen renderer; `None` only while it is dropped.
pub(crate) struct Renderer(Option<MjRenderer>);

impl Renderer {
    pub(crate) fn new(model: &MjModel, width: usize, height: usize) -> Result<Self, RendererError> {
        let _guard = DISPLAY.lock().unwrap_or_else(PoisonError::into_inner);
        MjRenderer::new(model, width, height, 0).map(|renderer| Self(Some(renderer)))
    }

    /// Renders the view of a camera: red, green and blue of each pixel, rows from the top.
    pub(crate) fn draw(
        &mut self,
        data: &mut MjData<Box<MjModel>>,
        camera: MjvCamera,
    ) -> Result<&[[u8; 3]], RendererError> {
        data.forward_kinematics();
        let _guard = DISPLAY.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(renderer) = &mut self.0 else { return Ok(&[]) };
        renderer.set_camera(camera);
        renderer.sync_data(data)?;
        renderer.render()?;
        Ok(renderer.rgb_flat().map_or(&[][..], |bytes| bytes.as_chunks::<3>().0))
    }
}

impl Drop for Renderer {
    fn drop(&mut self) {
        let _guard = DISPLAY.lock().unwrap_or_else(PoisonError::into_inner);
        self.0 = None;
    }
}

/// Formats a renderer error with its cause.
pub(crate) fn describe(error: &RendererError) -> String {
    let cause = core::error::Error::source(error).map_or_else(String::new, |cause| format!(" ({cause})"));
    format!("{error}{cause}")
}
