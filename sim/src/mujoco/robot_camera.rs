//! The robot's cameras: MuJoCo renders the picture off screen; the image sensor is shared with the kinematic simulator.

use bica_motion::robot::CameraId;
use glam::{Affine3A, Vec2, Vec3};
use mujoco_rs::prelude::{MjData, MjModel, MjtObjBase, MjvCamera};

use super::error::Error;
use super::renderer::{Renderer, describe};
use crate::camera::canvas::Canvas;
use crate::camera::image_sensor::ImageSensor;
use crate::camera::palette::{Palette, Rgb};
use crate::camera::pinhole::PinholeCamera;
use crate::random::{Random, Stream};
use crate::setup::Setup;
use crate::shared_image::{ImageMemory, SharedImage};
use bica_body::mujoco::find;

/// Both cameras with renderer and image sensor.
pub(crate) struct RobotCamera {
    seed: u64,
    renderer: Renderer,
    /// Indices of the cameras in the model, top first.
    cameras: [usize; 2],
    colour_response: ColourResponse,
    canvas: Canvas,
    sensor: ImageSensor,
    image: ImageMemory,
}

/// State of a camera during the exposure of an image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exposure {
    pub(crate) camera: CameraId,
    /// Pose in the field frame, x along the optical axis.
    pub(crate) pose: Affine3A,
    /// Focal lengths relative to the width and the height of the image.
    pub(crate) focal: Vec2,
    /// Angular velocity, camera frame, rad/s.
    pub(crate) angular_velocity: Vec3,
    /// Index of the image.
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
            colour_response: ColourResponse::new(&palette),
            canvas: Canvas::new(width, height),
            sensor: ImageSensor::new(&palette, width, height, &mut random),
            image: ImageMemory::new(2 * width * height),
        })
    }

    /// Takes an image. If the renderer fails, the previous picture is used again.
    pub(crate) fn take(&mut self, data: &mut MjData<Box<MjModel>>, exposure: &Exposure) {
        let camera = MjvCamera::new_fixed(self.cameras[exposure.camera as usize]);
        if let Ok(picture) = self.renderer.draw(data, camera) {
            self.colour_response.apply(picture, &mut self.canvas);
        }
        let view = PinholeCamera::new(exposure.pose, exposure.focal, self.canvas.width, self.canvas.height);
        let mut grain = Random::new(self.seed.wrapping_add(exposure.frame << 32), Stream::Grain);
        self.image.draw(|pixels| {
            self.sensor.expose(&self.canvas, &view, exposure.angular_velocity, &mut grain, pixels);
        });
    }

    /// Returns the newest image: width, height, YUYV.
    pub(crate) fn image(&self) -> (u16, u16, &[u8]) {
        (self.canvas.width as u16, self.canvas.height as u16, self.image.pixels())
    }

    /// Returns access to the newest image.
    pub(crate) fn shared(&self) -> SharedImage {
        self.image.shared()
    }
}

/// Lookup table from rendered colours to the camera's, with its exposure and white balance.
struct ColourResponse {
    /// Contribution of each value of each channel to luma, blue and red chroma, in 1/65536 counts.
    parts: [[[i32; 3]; 256]; 3],
}

impl ColourResponse {
    fn new(palette: &Palette) -> Self {
        let part = |channel: usize, value: usize| {
            let mut drawn = [0.0; 3];
            drawn[channel] = value as f32 / 255.0;
            let ycbcr = palette.ycbcr(Rgb::from(drawn));
            ycbcr.map(|count| (count * 65_536.0) as i32)
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
