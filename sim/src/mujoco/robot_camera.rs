//! The cameras: MuJoCo draws what they see, without a screen; the sensor behind the lens is the built-in world's.

use bica_motion::robot::CameraId;
use glam::{Affine3A, Vec3};
use mujoco_rs::prelude::{MjData, MjModel, MjtObjBase, MjvCamera};

use super::error::Error;
use super::model::find;
use super::renderer::Renderer;
use crate::camera::canvas::Canvas;
use crate::camera::image_sensor::ImageSensor;
use crate::camera::palette::{Palette, Rgb};
use crate::camera::pinhole::PinholeCamera;
use crate::random::{Random, Stream};
use crate::setup::Setup;

/// Both cameras and what makes images of their pictures.
pub(crate) struct RobotCamera {
    seed: u64,
    renderer: Renderer,
    /// The model's cameras, top first.
    cameras: [usize; 2],
    tint: Tint,
    canvas: Canvas,
    sensor: ImageSensor,
    image: Vec<u8>,
}

/// How a camera stood and turned when it took an image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim {
    pub(crate) camera: CameraId,
    /// Field from camera.
    pub(crate) pose: Affine3A,
    /// In the camera's own frame, rad/s.
    pub(crate) turning: Vec3,
    /// The image's number.
    pub(crate) frame: u64,
}

impl RobotCamera {
    pub(crate) fn new(setup: &Setup, model: &MjModel) -> Result<Self, Error> {
        let (width, height) = setup.frame.size();
        let renderer = Renderer::new(model, width, height).map_err(|error| Error::Camera(describe(&error)))?;
        let camera = |name| find(model, MjtObjBase::mjOBJ_CAMERA, name);
        let mut random = Random::new(setup.seed, Stream::Camera);
        let palette = Palette::new(&mut random);
        Ok(Self {
            seed: setup.seed,
            renderer,
            cameras: [camera("Top")?, camera("Bottom")?],
            tint: Tint::new(&palette),
            canvas: Canvas::new(width, height),
            sensor: ImageSensor::new(&palette, width, height, &mut random),
            image: vec![0; 2 * width * height],
        })
    }

    /// Takes an image. One that cannot be drawn stays as the last one was.
    pub(crate) fn take(&mut self, data: &mut MjData<Box<MjModel>>, aim: &Aim) {
        let camera = MjvCamera::new_fixed(self.cameras[aim.camera as usize]);
        if let Ok(picture) = self.renderer.draw(data, camera) {
            self.tint.apply(picture, &mut self.canvas);
        }
        let view = PinholeCamera::new(aim.pose, self.canvas.width, self.canvas.height);
        let mut grain = Random::new(self.seed.wrapping_add(aim.frame << 32), Stream::Grain);
        self.sensor.expose(&self.canvas, &view, aim.turning, &mut grain, &mut self.image);
    }

    /// The newest image: width, height, YUYV.
    pub(crate) fn image(&self) -> (u16, u16, &[u8]) {
        (self.canvas.width as u16, self.canvas.height as u16, &self.image)
    }
}

pub(crate) fn describe(error: &mujoco_rs::renderer::RendererError) -> String {
    let cause = core::error::Error::source(error).map_or_else(String::new, |cause| format!(" ({cause})"));
    format!("{error}{cause}")
}

/// A camera's colours for every red, green and blue that may be drawn.
struct Tint {
    /// What each value of each channel adds to luma, blue and red chroma; 1/65536 of a count.
    parts: [[[i32; 3]; 256]; 3],
}

impl Tint {
    fn new(palette: &Palette) -> Self {
        let part = |channel: usize, value: usize| {
            let mut drawn = [0.0; 3];
            drawn[channel] = value as f32 / 255.0;
            let seen = palette.seen(Rgb::from(drawn));
            seen.map(|count| (count * 65_536.0) as i32)
        };
        Self { parts: core::array::from_fn(|channel| core::array::from_fn(|value| part(channel, value))) }
    }

    fn apply(&self, picture: &[[u8; 3]], canvas: &mut Canvas) {
        const MIDDLE: [i32; 3] = [1 << 15, (128 << 16) + (1 << 15), (128 << 16) + (1 << 15)];
        for (drawn, pixel) in picture.iter().zip(&mut canvas.pixels) {
            let [r, g, b] = [0, 1, 2].map(|channel| &self.parts[channel][drawn[channel] as usize]);
            for i in 0..3 {
                pixel[i] = ((MIDDLE[i] + r[i] + g[i] + b[i]) >> 16).clamp(0, 255) as u8;
            }
        }
    }
}
