//! Robot in, robot out: what any NAO gives in a cycle and what it takes.
//!
//! The built-in world, a physics engine, a recording, a firmware link and a real NAO all speak these two types.
//! Nothing else of a world reaches a player.

use glam::Vec3;

use crate::joints::Joints;

/// One of the two cameras in the head. The robot sends the images of one at a time; [`Command::camera`] chooses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum CameraId {
    /// In the forehead, looks to the horizon.
    #[default]
    Top,
    /// In the mouth, looks 39.7° down, to the feet.
    Bottom,
}

/// A camera image as the camera made it, borrowed from whoever holds its memory.
#[derive(Clone, Copy, Debug)]
pub struct Image<'a> {
    /// The camera that took it.
    pub camera: CameraId,
    /// Width in pixels; even.
    pub width: u16,
    /// Height in pixels.
    pub height: u16,
    /// YUYV 4:2:2, rows from the top, two pixels in four bytes `Y0 Cb Y1 Cr`: `2 * width * height` bytes.
    pub yuyv: &'a [u8],
}

/// What the inertial unit in the torso measures. Torso frame: x forward, y left, z up.
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

/// Forces on the four pressure sensors of one sole, newtons, 0 when the foot is in the air.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    /// The whole force on the sole, newtons.
    #[must_use]
    pub fn total(&self) -> f32 {
        self.front_left + self.front_right + self.rear_left + self.rear_right
    }
}

/// Buttons and bumpers, true while pressed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Buttons {
    /// The button in the chest.
    pub chest: bool,
    /// Either bumper of the left foot.
    pub left_bumper: bool,
    /// Either bumper of the right foot.
    pub right_bumper: bool,
}

/// Everything that a robot tells in one cycle.
#[derive(Clone, Copy, Debug)]
pub struct Sensors<'a> {
    /// Measured joint angles, rad.
    pub angles: Joints<f32>,
    /// How hot the joints' motors are, °C; NaN where a robot cannot tell. A NAO V6 tells whole degrees of all.
    pub temperatures: Joints<f32>,
    /// What the joints' motors draw, A, 0 or more; NaN where a robot cannot tell.
    pub currents: Joints<f32>,
    /// The inertial unit.
    pub inertial: Inertial,
    /// Pressure under the left sole.
    pub left_foot: FootPressure,
    /// Pressure under the right sole.
    pub right_foot: FootPressure,
    /// Buttons and bumpers.
    pub buttons: Buttons,
    /// The image, in the cycles in which a new one came.
    pub image: Option<Image<'a>>,
}

/// An RGB light, each part 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Light(pub f32, pub f32, pub f32);

/// The lights that a player may set.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lights {
    /// In the chest button.
    pub chest: Light,
    /// All lights of the left eye.
    pub left_eye: Light,
    /// All lights of the right eye.
    pub right_eye: Light,
}

/// Everything that a robot is told in one cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Command {
    /// Wanted joint angles, rad.
    pub targets: Joints<f32>,
    /// How hard each joint holds its target, 0 (limp) to 1.
    pub stiffness: Joints<f32>,
    /// Lights.
    pub lights: Lights,
    /// The camera whose images are wanted.
    pub camera: CameraId,
}
