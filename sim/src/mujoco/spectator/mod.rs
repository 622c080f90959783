//! The spectator camera. It renders a separate model with more detail, which affects neither the physics nor the robot's own
//! images.

mod hall;
pub(super) mod scene;

use bica_motion::kinematics::{Segment, Skeleton};
use bica_motion::model::simulation::SimulatedModel;
use glam::{Affine3A, Vec3};
use mujoco_rs::prelude::{MjData, MjModel, MjvCamera};
use mujoco_rs::renderer::RendererError;

use super::renderer::{Renderer, describe};
use crate::layout::Layout;
use crate::setup::Setup;
use crate::spectator::{Picture, RenderError, SpectatorCamera};
use bica_body::mujoco::{Data, write};

/// Supersampling factor along each axis.
const SUPERSAMPLING: usize = 2;

/// Renderer of spectator views.
pub(crate) struct SpectatorRenderer {
    renderer: Renderer,
    data: Data,
    width: usize,
    height: usize,
}

/// Poses of the moving objects, field frame.
pub(crate) struct Moving {
    /// Robot frame.
    pub(crate) robot: Affine3A,
    /// Segments in the robot frame.
    pub(crate) skeleton: Skeleton,
    /// Centre of the ball, m.
    pub(crate) ball: Vec3,
}

impl SpectatorRenderer {
    pub(crate) fn new(
        model: &'static SimulatedModel,
        setup: &Setup,
        layout: &Layout,
        width: usize,
        height: usize,
    ) -> Result<Self, RenderError> {
        let model = MjModel::from_xml_string(&scene::write(model, setup, layout))
            .map_err(|error| RenderError(format!("MuJoCo rejects the model of the spectator view: {error}")))?;
        let renderer = renderer(&model, width, height)?;
        Ok(Self { renderer, data: MjData::new(Box::new(model)), width, height })
    }

    /// Width and height of pictures, pixels.
    pub(crate) const fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// Renders a picture.
    pub(crate) fn render(&mut self, moving: &Moving, spectator: &SpectatorCamera) -> Result<Picture, RenderError> {
        self.place(scene::BALL, &Affine3A::from_translation(moving.ball));
        self.place(scene::LAMP, &Affine3A::from_translation(spectator.target));
        for segment in Segment::ALL {
            self.place(scene::ROBOT + segment.index(), &(moving.robot * moving.skeleton.pose(segment)));
        }
        picture(&mut self.renderer, &mut self.data, spectator, (self.width, self.height))
    }

    fn place(&mut self, body: usize, pose: &Affine3A) {
        let (_, turn, at) = pose.to_scale_rotation_translation();
        write(&mut self.data.mocap_pos_mut()[body], &at.to_array());
        write(&mut self.data.mocap_quat_mut()[body], &[turn.w, turn.x, turn.y, turn.z]);
    }
}

/// Returns a renderer for pictures of a size, pixels.
pub(super) fn renderer(model: &MjModel, width: usize, height: usize) -> Result<Renderer, RenderError> {
    Renderer::new(model, SUPERSAMPLING * width, SUPERSAMPLING * height).map_err(|error| failed(&error))
}

/// Renders a picture of a size, pixels.
pub(super) fn picture(
    renderer: &mut Renderer,
    data: &mut Data,
    spectator: &SpectatorCamera,
    (width, height): (usize, usize),
) -> Result<Picture, RenderError> {
    let offset = spectator.target - spectator.eye;
    let (up, along) = (offset.z, offset.truncate());
    let mut camera = MjvCamera::new_free(data.model());
    camera.lookat = spectator.target.to_array().map(f64::from);
    camera.distance = offset.length().into();
    camera.azimuth = along.y.atan2(along.x).to_degrees().into();
    camera.elevation = up.atan2(along.length()).to_degrees().into();
    let drawn = renderer.draw(data, camera).map_err(|error| failed(&error))?;
    Ok(Picture { width, height, rgb: downsample(drawn, width, height) })
}

/// Averages squares of [`SUPERSAMPLING`] by [`SUPERSAMPLING`] pixels.
fn downsample(drawn: &[[u8; 3]], width: usize, height: usize) -> Vec<[u8; 3]> {
    let at = |x: usize, y: usize| drawn.get(y * SUPERSAMPLING * width + x).copied().unwrap_or_default();
    let mean = |x: usize, y: usize| {
        let square = (0..SUPERSAMPLING * SUPERSAMPLING)
            .map(|i| at(SUPERSAMPLING * x + i % SUPERSAMPLING, SUPERSAMPLING * y + i / SUPERSAMPLING));
        let sum = square.fold([0_usize; 3], |sum, rgb| core::array::from_fn(|i| sum[i] + usize::from(rgb[i])));
        sum.map(|part| (part / (SUPERSAMPLING * SUPERSAMPLING)) as u8)
    };
    (0..height).flat_map(|y| (0..width).map(move |x| mean(x, y))).collect()
}

/// Converts a renderer error.
fn failed(error: &RendererError) -> RenderError {
    RenderError(describe(error))
}
