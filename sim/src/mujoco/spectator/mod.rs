//! The camera outside. What it sees is a model of its own: what only onlookers see, or what is drawn more finely for them,
//! touches neither the physics nor the robot's own images.

mod hall;
mod loft;
mod scene;
mod shells;

use bica_motion::kinematics::{Segment, Skeleton};
use glam::{Affine3A, Vec3};
use mujoco_rs::prelude::{MjData, MjModel, MjvCamera};
use mujoco_rs::renderer::RendererError;

use super::renderer::Renderer;
use super::robot_camera::describe;
use super::state::write;
use crate::layout::Layout;
use crate::setup::Setup;
use crate::spectator::{Picture, RenderError, SpectatorCamera};

/// Drawn pixels of a picture's, across and down: their mean has smooth edges.
const FINE: usize = 2;

/// A camera that may be anywhere.
pub(crate) struct SpectatorRenderer {
    renderer: Renderer,
    data: MjData<Box<MjModel>>,
    width: usize,
    height: usize,
}

/// What moves, field frame.
pub(crate) struct Moving {
    pub(crate) robot: Affine3A,
    pub(crate) skeleton: Skeleton,
    /// The ball's middle.
    pub(crate) ball: Vec3,
}

impl SpectatorRenderer {
    pub(crate) fn new(setup: &Setup, layout: &Layout, width: usize, height: usize) -> Result<Self, RenderError> {
        let model = MjModel::from_xml_string(&scene::write(setup, layout))
            .map_err(|error| RenderError(format!("MuJoCo does not take the model that is filmed: {error}")))?;
        let renderer = Renderer::new(&model, FINE * width, FINE * height).map_err(|error| failed(&error))?;
        Ok(Self { renderer, data: MjData::new(Box::new(model)), width, height })
    }

    /// Width and height of pictures, pixels.
    pub(crate) const fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    pub(crate) fn take(&mut self, moving: &Moving, from: &SpectatorCamera) -> Result<Picture, RenderError> {
        self.place(scene::BALL, &Affine3A::from_translation(moving.ball));
        self.place(scene::LAMP, &Affine3A::from_translation(from.target));
        for segment in Segment::ALL {
            self.place(scene::ROBOT + segment.index(), &(moving.robot * moving.skeleton.pose(segment)));
        }
        let camera = self.camera(from);
        let drawn = self.renderer.draw(&mut self.data, camera).map_err(|error| failed(&error))?;
        Ok(Picture { width: self.width, height: self.height, rgb: smooth(drawn, self.width, self.height) })
    }

    fn place(&mut self, body: usize, pose: &Affine3A) {
        let (_, turn, at) = pose.to_scale_rotation_translation();
        write(&mut self.data.mocap_pos_mut()[body], &at.to_array());
        write(&mut self.data.mocap_quat_mut()[body], &[turn.w, turn.x, turn.y, turn.z]);
    }

    fn camera(&self, from: &SpectatorCamera) -> MjvCamera {
        let way = from.target - from.eye;
        let (up, along) = (way.z, way.truncate());
        let mut camera = MjvCamera::new_free(self.data.model());
        camera.lookat = from.target.to_array().map(f64::from);
        camera.distance = way.length().into();
        camera.azimuth = along.y.atan2(along.x).to_degrees().into();
        camera.elevation = up.atan2(along.length()).to_degrees().into();
        camera
    }
}

/// Means of squares of [`FINE`] by [`FINE`] pixels.
fn smooth(drawn: &[[u8; 3]], width: usize, height: usize) -> Vec<[u8; 3]> {
    let at = |x: usize, y: usize| drawn.get(y * FINE * width + x).copied().unwrap_or_default();
    let mean = |x: usize, y: usize| {
        let square = (0..FINE * FINE).map(|i| at(FINE * x + i % FINE, FINE * y + i / FINE));
        let sum = square.fold([0_usize; 3], |sum, rgb| core::array::from_fn(|i| sum[i] + usize::from(rgb[i])));
        sum.map(|part| (part / (FINE * FINE)) as u8)
    };
    (0..height).flat_map(|y| (0..width).map(move |x| mean(x, y))).collect()
}

fn failed(error: &RendererError) -> RenderError {
    RenderError(describe(error))
}
