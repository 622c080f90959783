//! Interface between a robot and its controller: sensors and commands of one control cycle.
//!
//! A simulated world, a recording, a firmware link and a real robot all use these two types. A controller receives nothing
//! else from its world.

use core::fmt;

use glam::Vec3;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use crate::joints::Joints;

/// One of the two cameras in the head. The robot sends images of one camera at a time; [`Command::camera`] selects it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, Schema)]
pub enum CameraId {
    /// In the forehead, directed to the horizon.
    #[default]
    Top,
    /// In the mouth, directed to the ground before the feet.
    Bottom,
}

/// Raw camera image, borrowed from the owner of its memory.
#[derive(Clone, Copy, Debug)]
pub struct Image<'a> {
    /// Source of the image.
    pub camera: CameraId,
    /// Width in pixels; even.
    pub width: u16,
    /// Height in pixels.
    pub height: u16,
    /// YUYV 4:2:2, rows from the top, two pixels in four bytes `Y0 Cb Y1 Cr`: `2 * width * height` bytes.
    pub yuyv: &'a [u8],
}

/// Readings of the inertial unit in the torso. Torso frame: x forward, y left, z up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inertial {
    /// Angular velocity, rad/s.
    pub gyro: Vec3,
    /// Specific force, m/s²: (0, 0, +9.81) when standing upright and still.
    pub acceleration: Vec3,
    /// Estimated torso roll, rad; positive leans to the right.
    pub roll: f32,
    /// Estimated torso pitch, rad; positive leans forward.
    pub pitch: f32,
}

/// Largest joint angle that a sensor in order measures, rad.
const MAX_ANGLE: f32 = 4.0;
/// Largest turn rate, rad/s: 2000 °/s, with a margin.
const MAX_GYRO: f32 = 40.0;
/// Largest specific force, m/s²: 16 g, with a margin.
const MAX_ACCELERATION: f32 = 200.0;
/// Largest force on a pressure sensor, N.
const MAX_FORCE: f32 = 5000.0;
/// Temperatures of a motor, °C.
const TEMPERATURES: core::ops::RangeInclusive<f32> = -40.0..=200.0;

/// Whether a joint can have this angle, rad.
#[must_use]
pub const fn is_plausible_angle(angle: f32) -> bool {
    angle.abs() <= MAX_ANGLE
}

/// Returns a temperature that a motor can have, °C; NaN, which means unknown, in place of another one.
#[must_use]
pub fn plausible_temperature(temperature: f32) -> f32 {
    if TEMPERATURES.contains(&temperature) { temperature } else { f32::NAN }
}

impl Inertial {
    /// Whether the values are finite and within what inertial units measure.
    #[must_use]
    pub fn is_plausible(&self) -> bool {
        let within = |vector: Vec3, most: f32| vector.abs().cmple(Vec3::splat(most)).all();
        within(self.gyro, MAX_GYRO)
            && within(self.acceleration, MAX_ACCELERATION)
            && is_plausible_angle(self.roll)
            && is_plausible_angle(self.pitch)
    }
}

/// Forces on the four pressure sensors of one sole, N; 0 when the foot is in the air.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Schema)]
pub struct FootPressure {
    /// Under the toes, left side.
    pub front_left: f32,
    /// Under the toes, right side.
    pub front_right: f32,
    /// Under the heel, left side.
    pub rear_left: f32,
    /// Under the heel, right side.
    pub rear_right: f32,
}

impl FootPressure {
    /// Whether the values are finite and within what pressure sensors measure.
    #[must_use]
    pub const fn is_plausible(&self) -> bool {
        self.front_left.abs() <= MAX_FORCE
            && self.front_right.abs() <= MAX_FORCE
            && self.rear_left.abs() <= MAX_FORCE
            && self.rear_right.abs() <= MAX_FORCE
    }

    /// Total force on the sole, N.
    #[must_use]
    pub fn total(&self) -> f32 {
        self.front_left + self.front_right + self.rear_left + self.rear_right
    }
}

/// Buttons and bumpers; true while pressed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Buttons {
    /// The button in the chest.
    pub chest: bool,
    /// Either bumper of the left foot.
    pub left_bumper: bool,
    /// Either bumper of the right foot.
    pub right_bumper: bool,
}

/// Sensor readings of one control cycle.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Sensors<'a> {
    /// Measured joint angles, rad.
    pub angles: Joints<f32>,
    /// Temperatures of the joints' motors, °C; NaN where unknown. A NAO V6 reports whole degrees for all joints.
    pub temperatures: Joints<f32>,
    /// Currents of the joints' motors, A, 0 or more; NaN where unknown.
    pub currents: Joints<f32>,
    /// Inertial unit.
    pub inertial: Inertial,
    /// Pressure under the left sole.
    pub left_foot: FootPressure,
    /// Pressure under the right sole.
    pub right_foot: FootPressure,
    /// Buttons and bumpers.
    pub buttons: Buttons,
    /// New image; `None` in cycles without one.
    #[serde(borrow, deserialize_with = "crate::message::whole_image")]
    pub image: Option<Image<'a>>,
}

impl Sensors<'_> {
    /// Values before the first measurement: zero, and NaN for what may be unknown.
    pub const UNMEASURED: Self = Self {
        angles: Joints::all(0.0),
        temperatures: Joints::all(f32::NAN),
        currents: Joints::all(f32::NAN),
        inertial: Inertial { gyro: Vec3::ZERO, acceleration: Vec3::ZERO, roll: 0.0, pitch: 0.0 },
        left_foot: FootPressure { front_left: 0.0, front_right: 0.0, rear_left: 0.0, rear_right: 0.0 },
        right_foot: FootPressure { front_left: 0.0, front_right: 0.0, rear_left: 0.0, rear_right: 0.0 },
        buttons: Buttons { chest: false, left_bumper: false, right_bumper: false },
        image: None,
    };
}

/// RGB light; red, green and blue are 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Schema)]
pub struct Light(pub f32, pub f32, pub f32);

/// Lights that a controller may set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Schema)]
pub struct Lights {
    /// Chest button.
    pub chest: Light,
    /// Left eye, all lights.
    pub left_eye: Light,
    /// Right eye, all lights.
    pub right_eye: Light,
}

/// Command of one control cycle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Command {
    /// Target joint angles, rad.
    pub targets: Joints<f32>,
    /// Stiffness of each joint, 0 (limp) to 1.
    pub stiffness: Joints<f32>,
    /// Lights.
    pub lights: Lights,
    /// Camera whose images are requested.
    pub camera: CameraId,
}

/// The command contains a value that is not finite or out of range, so no part of it may be executed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InvalidCommand;

impl fmt::Display for InvalidCommand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the command contains a value that is not finite or out of range")
    }
}

impl core::error::Error for InvalidCommand {}

impl Command {
    /// Checks a command that was received.
    ///
    /// # Errors
    /// [`InvalidCommand`] if a target is not finite, or a stiffness or light is not within 0 and 1.
    pub fn check(&self) -> Result<(), InvalidCommand> {
        let is_fraction = |value: &f32| (0.0..=1.0).contains(value);
        let Lights { chest, left_eye, right_eye } = self.lights;
        let lights = [chest, left_eye, right_eye].map(|Light(red, green, blue)| [red, green, blue]);
        let is_valid = self.targets.0.iter().all(|target| target.is_finite())
            && self.stiffness.0.iter().all(is_fraction)
            && lights.as_flattened().iter().all(is_fraction);
        is_valid.then_some(()).ok_or(InvalidCommand)
    }

    /// A command with one stiffness for all joints, 0 to 1, dark lights and the top camera.
    #[must_use]
    pub fn new(targets: Joints, stiffness: f32) -> Self {
        Self { targets, stiffness: Joints::all(stiffness), lights: Lights::default(), camera: CameraId::Top }
    }
}
