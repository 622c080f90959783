//! Faults of a robot's sensors and joints, which a test can add to any world.

use core::fmt;
use core::str::FromStr;
use core::time::Duration;

use bica_core::action::Actions;
use bica_motion::joints::Joint;
use bica_motion::pose::Pose2;
use bica_motion::robot::{Command, Image, Sensors};
use glam::Vec2;

use crate::random::{Random, Stream};
use crate::referee::Referee;
use crate::setup::Frame;
use crate::shared_image::{ImageMemory, SharedImage};
use crate::spectator::{Picture, RenderError, SpectatorCamera, SpectatorView};
use crate::world::World;

/// Temperature of a hot motor, °C.
const HOT: f32 = 95.0;
/// Amplitude of the noise of an image, of 255.
const NOISE: f32 = 90.0;
/// Duration of a press of the chest button, s.
const PRESS: f32 = 0.3;

/// Fault of the camera's images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageFault {
    /// It repeats its last image.
    Freeze,
    /// Its images are almost black.
    Dark,
    /// Its images are almost white.
    Bright,
    /// Its images are full of noise.
    Noise,
    /// It sends no images.
    Drop,
}

/// Error: the text does not name an [`ImageFault`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownFault;

impl fmt::Display for UnknownFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("give freeze, dark, bright, noise or drop")
    }
}

impl core::error::Error for UnknownFault {}

impl FromStr for ImageFault {
    type Err = UnknownFault;

    fn from_str(text: &str) -> Result<Self, UnknownFault> {
        Ok(match text {
            "freeze" => Self::Freeze,
            "dark" => Self::Dark,
            "bright" => Self::Bright,
            "noise" => Self::Noise,
            "drop" => Self::Drop,
            _ => return Err(UnknownFault),
        })
    }
}

/// Faults and the time in which they are active.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faults {
    /// Fault of the camera.
    pub image: Option<ImageFault>,
    /// Offset of the gyroscope about the vertical axis, rad/s.
    pub gyro: f32,
    /// Joint that stays at its angle.
    pub stuck: Option<Joint>,
    /// Joint whose temperature sensor reports a hot motor.
    pub hot: Option<Joint>,
    /// Time from which the faults are active, s.
    pub from: f32,
    /// Time until which they are active, s.
    pub until: f32,
    /// Times at which the chest button is pressed, s.
    pub presses: [f32; 2],
}

impl Default for Faults {
    fn default() -> Self {
        let never = f32::INFINITY;
        Self { image: None, gyro: 0.0, stuck: None, hot: None, from: 0.0, until: never, presses: [never; 2] }
    }
}

/// A world whose robot has faults.
pub struct FaultyWorld {
    world: Box<dyn SpectatorView>,
    faults: Faults,
    /// Angle of the stuck joint, rad.
    held: Option<f32>,
    /// The image of this cycle, and the last pixels.
    image: ImageMemory,
    pixels: Vec<u8>,
    /// Time of the cycle whose image was drawn.
    drawn: Option<Duration>,
    noise: Random,
}

impl FaultyWorld {
    /// Adds faults to a world with images of a size. The seed determines the noise.
    #[must_use]
    pub fn new(world: Box<dyn SpectatorView>, faults: Faults, frame: Frame, seed: u64) -> Self {
        let (width, height) = frame.size();
        let (bytes, noise) = (2 * width * height, Random::new(seed, Stream::Faults));
        let (image, pixels) = (ImageMemory::new(bytes), vec![0; bytes]);
        Self { world, faults, held: None, image, pixels, drawn: None, noise }
    }

    fn is_faulty(&self) -> bool {
        (self.faults.from..self.faults.until).contains(&self.world.now().as_secs_f32())
    }
}

/// Replaces the pixels of the last image, in YUYV 4:2:2, by those of a new image with a fault.
fn draw(fault: ImageFault, last: &mut [u8], new: &[u8], noise: &mut Random) {
    if matches!(fault, ImageFault::Freeze | ImageFault::Drop) {
        return;
    }
    for (last, new) in last.as_chunks_mut::<2>().0.iter_mut().zip(new.as_chunks::<2>().0) {
        let [luma, chroma] = *new;
        *last = match fault {
            ImageFault::Dark => [luma / 16, 128],
            ImageFault::Bright => [240 + luma / 17, 128],
            _ => [(f32::from(luma) + noise.between(-NOISE, NOISE)) as u8, chroma],
        };
    }
}

impl World for FaultyWorld {
    fn now(&self) -> Duration {
        self.world.now()
    }

    fn sensors(&mut self) -> Sensors<'_> {
        let (now, is_faulty) = (self.world.now(), self.is_faulty());
        let mut sensors = self.world.sensors();
        let pressed = |from: f32| (from..from + PRESS).contains(&now.as_secs_f32());
        sensors.buttons.chest |= self.faults.presses.into_iter().any(pressed);
        if let (Some(fault), Some(image)) = (self.faults.image, sensors.image) {
            if self.drawn.replace(now) != Some(now) {
                if is_faulty {
                    draw(fault, &mut self.pixels, image.yuyv, &mut self.noise);
                } else {
                    self.pixels.copy_from_slice(image.yuyv);
                }
                self.image.draw(|pixels| pixels.copy_from_slice(&self.pixels));
            }
            let is_sent = !(is_faulty && fault == ImageFault::Drop);
            sensors.image = is_sent.then_some(Image { yuyv: self.image.pixels(), ..image });
        }
        if is_faulty {
            sensors.inertial.gyro.z += self.faults.gyro;
            if let Some(joint) = self.faults.hot {
                sensors.temperatures[joint] = HOT;
            }
        }
        sensors
    }

    fn act(&mut self, command: &Command) {
        let mut command = *command;
        if let Some(joint) = self.faults.stuck.filter(|_| self.is_faulty()) {
            let angle = self.world.sensors().angles[joint];
            command.targets[joint] = *self.held.get_or_insert(angle);
            command.stiffness[joint] = 1.0;
        } else {
            self.held = None;
        }
        self.world.act(&command);
    }

    fn actions(&mut self) -> &mut dyn Actions {
        self.world.actions()
    }

    fn put_ball(&mut self, at: Vec2) -> Result<(), &'static str> {
        self.world.put_ball(at)
    }

    fn put_robot(&mut self, at: Pose2) -> Result<(), &'static str> {
        self.world.put_robot(at)
    }

    fn add_velocity(&mut self, velocity: Vec2) {
        self.world.add_velocity(velocity);
    }

    fn failure(&self) -> Option<&str> {
        self.world.failure()
    }

    fn shared_image(&self) -> SharedImage {
        if self.faults.image.is_some() { self.image.shared() } else { self.world.shared_image() }
    }

    fn referee(&self) -> &Referee {
        self.world.referee()
    }
}

impl SpectatorView for FaultyWorld {
    fn render_from(&mut self, camera: &SpectatorCamera, width: usize, height: usize) -> Result<Picture, RenderError> {
        self.world.render_from(camera, width, height)
    }
}
