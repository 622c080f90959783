//! Properties of a humanoid that only simulators need: extents, postures on the ground, looks, and its body in `MuJoCo`.
//!
//! A program for a real robot does not link them.

use core::ops::Deref;

use glam::Vec2;

use super::{Actuator, Range, RobotModel};
use crate::joints::Joints;
use crate::segment::Segment;

pub use super::k1::SIMULATED as K1;
pub use super::nao::SIMULATED as NAO;
pub use super::t1::SIMULATED as T1;

/// All humanoids of this crate. Programs offer these, and tests check each.
pub const HUMANOIDS: &[&SimulatedModel] = &[NAO, T1, K1];

/// The humanoid with this [`id`](RobotModel::id).
#[must_use]
pub fn humanoid(id: &str) -> Option<&'static SimulatedModel> {
    HUMANOIDS.iter().copied().find(|model| model.id == id)
}

/// A humanoid that simulators can move and draw. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SimulatedModel {
    /// What its own program knows of it.
    pub robot: &'static RobotModel,
    /// Extents in contacts.
    pub extents: &'static Extents,
    /// Postures on the ground.
    pub lying: &'static Lying,
    /// Looks in rendered images.
    pub figure: &'static Figure,
    /// Motors whose continuous copper loss the motor of each joint bears.
    pub thermal_ratings: &'static Joints<Actuator>,
    /// Its body in `MuJoCo`.
    pub mujoco: MujocoModel,
}

impl Deref for SimulatedModel {
    type Target = RobotModel;

    fn deref(&self) -> &RobotModel {
        self.robot
    }
}

/// The body of a humanoid in `MuJoCo`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MujocoModel {
    /// MJCF file of the robot.
    ///
    /// Bodies have the names and frames of [`Segment`]s and joints and actuators (torque motors) the names of
    /// [`RobotModel::joints`], sides abbreviated: `LFoot`, `RHipPitch`. The root is the body `Torso` with a free joint of that
    /// name. A right hip yaw-pitch that shares its motor follows the left one; the names of joints in the place of others are
    /// `LHipYaw`, `RHipYaw` and `WaistYaw`. Further elements: a camera `Top` and one `Bottom`, the geoms `LSole`
    /// and `RSole` (friction) and `LFootShell` and `RFootShell`, a material `team`. Sensors, in this order: a gyroscope, an
    /// accelerometer, and, if [`Senses::soles`](super::Senses), the forces on the left and the right sole:
    /// front left, front right, rear left, rear right.
    /// Contact types: 1 body, 2 sole, 4 floor, 8 obstacle, 16 ball, 32 foot shell.
    pub robot: &'static str,
    /// Geoms in MJCF of a robot that stands still, from the ground below its robot frame. The material `team` is replaced by
    /// its team's; `shells` and `joints` exist.
    pub bystander: &'static str,
    /// MJCF file of the looks in films: a body for each segment, named as in [`robot`](Self::robot). The material `team` is
    /// replaced by the team's.
    pub shells: &'static str,
    /// Position gain of each motor at full stiffness, Nm/rad.
    pub gains: &'static Joints,
    /// Torque limit of each joint, Nm.
    pub torque_limits: &'static Joints,
    /// Whether the joints' damping is the velocity gain of the motors, which the torque limit includes.
    pub motors_damp: bool,
    /// Half length and half width of the shadows of foot and torso.
    pub shadows: [Vec2; 2],
}

/// A disc whose centre lies on the x axis of its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Distance of the centre from the origin, forward.
    pub ahead: f32,
    /// Radius.
    pub radius: f32,
}

/// Extents of a body in contacts with ground, ball, posts and other robots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extents {
    /// Radius of the disc around the robot frame that a standing robot needs.
    pub standing: f32,
    /// Radius of the disc around the robot frame that a lying robot may cover.
    pub lying: f32,
    /// Radius of the torso without the arms, which yield.
    pub torso: f32,
    /// Disc that covers the front of a foot, sole frame.
    pub foot_front: Disc,
    /// Height of a foot's shell.
    pub foot_height: f32,
    /// Distance of a sole's middle from the origin of its frame, forward.
    pub sole_middle: f32,
    /// Disc around each leg of a standing robot, relative to its hip.
    pub leg: Disc,
    /// Length of the trunk of a lying robot, from the robot frame up.
    pub trunk_length: f32,
    /// Radius of the trunk of a lying robot.
    pub trunk_radius: f32,
    /// Minimum height of the robot frame of a standing robot.
    pub min_hip_height: f32,
}

/// Postures on the ground, for a world without contact forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lying {
    /// Distance of the robot frame from the feet after a fall, along the ground.
    pub fall_length: f32,
    /// Height of the robot frame of a robot that lies on its front.
    pub front_height: f32,
    /// Height of the robot frame of a robot that lies on its back.
    pub back_height: f32,
    /// Height of the robot frame of a robot that lies on a side.
    pub side_height: f32,
    /// Bend of both hips beyond which the robot sits instead of lying, rad: the torso is off the ground.
    pub sitting_hip: f32,
    /// Lean of the torso of a sitting robot, rad.
    pub sitting_lean: f32,
    /// Bend of both knees that a robot must have passed before it can rise, rad.
    pub folded_knee: f32,
    /// Bend of the knees in the posture in which it rises, rad: below, the legs are stretched; above, it squats.
    pub rising_knee: Range,
}

/// Looks of a robot: solids of single colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Parts of the trunk below the head.
    pub trunk: &'static [Part],
    /// Parts of the left side; the right side is the mirror image.
    pub side: &'static [Part],
    /// Parts of the head, which the robot's own cameras do not show.
    pub head: &'static [Part],
    /// Shadow below a foot, sole frame.
    pub foot_shadow: Disc,
}

/// A visible part: the segment in whose frame its solid is given, and its colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part(pub Segment, pub Paint, pub Solid);

/// Shape of a part, in its segment's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// A sphere: centre and radius.
    Sphere([f32; 3], f32),
    /// A tube: ends of its axis, and radius at each.
    Tube([[f32; 3]; 2], [f32; 2]),
    /// A box: centre, and half of its lengths along the axes.
    Block([f32; 3], [f32; 3]),
}

/// Colour of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    /// Colour of the shells.
    Shell,
    /// Colour of joints and other inner parts.
    Joint,
    /// Colour of the team.
    Team,
}

impl Part {
    /// Mirror image of the part on the other side.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let image = |[x, y, z]: [f32; 3]| [x, -y, z];
        let Self(segment, paint, solid) = *self;
        let solid = match solid {
            Solid::Sphere(centre, radius) => Solid::Sphere(image(centre), radius),
            Solid::Tube(ends, radii) => Solid::Tube(ends.map(image), radii),
            Solid::Block(centre, half) => Solid::Block(image(centre), half),
        };
        Self(segment.mirrored(), paint, solid)
    }
}
