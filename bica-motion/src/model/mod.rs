//! Robot model: the properties of a humanoid that the algorithms of this crate need, as a value.
//!
//! A robot is a constant of type [`RobotModel`], for example [`NAO`]. The algorithms take it as their first argument, and those
//! with a state keep a reference to it.
//!
//! A robot with other proportions, limits, masses, motors or tuned motions needs no change in this crate: make a constant
//! and pass it, for example `Walk::new(MY_ROBOT, &MY_ROBOT.dynamic_profile.gait)`.
//!
//! # What a model must have
//! - Legs with six joints in the order hip yaw-pitch, hip roll, hip pitch, knee pitch, ankle pitch, ankle roll. One motor
//!   drives the hip yaw-pitch of both legs; its axis is tilted by 45°. Or legs with hip pitch, roll and yaw from the torso down, each
//!   with a motor of its own: [`LegGeometry::PitchRollYaw`].
//! - A head with yaw below pitch, and at most two cameras in it.
//! - Arms with shoulder pitch, shoulder roll, elbow yaw, elbow roll and wrist yaw. Missing arm joints are left out of
//!   [`joints`](RobotModel::joints); their angles are computed but not used. At zero they point ahead, or to the sides
//!   ([`ArmGeometry`]).
//! - An inertial unit. Four pressure sensors in each sole and an own estimate of roll and pitch are used if the robot has them
//!   ([`Senses`]); otherwise both are [estimated](crate::senses).
//! - A control cycle near 10 ms: filter gains are given for it.
//!
//! What simulators need besides is in [`simulation`].

mod actuator;
mod arm;
mod body;
mod booster;
mod booster_getup;
mod booster_kicks;
mod calibration;
mod dimensions;
mod gait;
mod getup;
mod head;
mod k1;
mod kicks;
mod leg;
mod limits;
mod mass;
mod nao;
mod pitch_first;
mod posture;
mod profile;
mod range;
mod senses;
pub mod simulation;
mod stiffness;
mod t1;

pub use actuator::Actuator;
pub use arm::{ArmGeometry, SidewaysArm};
pub use body::{BodyShape, Capsule};
pub use calibration::Calibration;
pub use dimensions::{CameraMount, Dimensions};
pub use gait::Parameters;
pub use getup::{GetUpFrame, GetUpFrames};
pub use head::{HeadPitchLimit, HeadSpeed};
pub use k1::K1;
pub use kicks::{KickFrame, KickPose, Kicks, Technique};
pub use limits::{FallLimits, ThermalLimits};
pub use mass::{Mass, Masses};
pub use nao::NAO;
pub use pitch_first::{LegGeometry, PitchFirstLeg};
pub use posture::{FallPostures, symmetric};
pub use profile::Profile;
pub use range::Range;
pub use senses::Senses;
pub use stiffness::{LimbStiffness, StiffnessTable};
pub use t1::T1;

use core::fmt::{self, Debug, Formatter};

use glam::Affine3A;

use crate::joints::{Joint, Joints};
use crate::keyframes::Keyframe;
use crate::limbs::LegAngles;
use crate::side::Side;

/// A humanoid robot as data. See the [module](self) for what is covered.
///
/// Units are m, rad, s, kg, N, unless stated otherwise; x forward, y left, z up.
pub struct RobotModel {
    /// Name on command lines and in files, for example `t1`.
    pub id: &'static str,
    /// Name for people.
    pub name: &'static str,
    /// Joints that the robot has.
    pub joints: &'static [Joint],
    /// Range of each joint, independent of the other joints.
    pub limits: &'static Joints<Range>,
    /// Maximum speed of each joint, rad/s; a hand: 1/s.
    pub max_speeds: &'static Joints,
    /// Motor and gear of each joint.
    pub actuators: &'static Joints<Actuator>,
    /// Time from a command to the first motion of a joint, s.
    pub dead_time: f32,
    /// Time from a command until the measured angle follows it.
    pub feedback_delay: FeedbackDelay,
    /// Thermal limits of the motors.
    pub thermal: ThermalLimits,
    /// Pitch range of the head at several yaws, in ascending order of the yaw from 0. At least one.
    pub head_pitch_limits: &'static [HeadPitchLimit],
    /// Speed of the head at which camera images are not blurred.
    pub head_speed: HeadSpeed,
    /// Lengths, and places of the sensors.
    pub dimensions: &'static Dimensions,
    /// Height of the cameras over the ground in a walking robot, m.
    pub camera_height: f32,
    /// Outer shape.
    pub body_shape: &'static BodyShape,
    /// Masses of all segments.
    pub masses: &'static Masses,
    /// Minimum force on a foot that supports the robot alone, N.
    pub support_force: f32,
    /// Torso angles within which the robot does not fall.
    pub fall_limits: FallLimits,
    /// Stiffness of the joints.
    pub stiffness: &'static StiffnessTable,
    /// Posture from which motions begin and in which they end.
    pub stand: Joints,
    /// A crouch on flat feet that is stable with little force.
    pub sit: Joints,
    /// Minimum stiffness that holds [`sit`](Self::sit), 0 to 1.
    pub sit_stiffness: f32,
    /// Motion from any posture near the stand to [`stand`](Self::stand).
    pub to_stand: &'static [Keyframe],
    /// Motion from the stand to [`sit`](Self::sit).
    pub to_sit: &'static [Keyframe],
    /// Key postures of getting up.
    pub get_up: &'static GetUpFrames,
    /// Postures for a fall.
    pub fall_postures: &'static FallPostures,
    /// Motions for a world without dynamics: quasi-static gait, no slip.
    pub kinematic_profile: &'static Profile,
    /// Motions for a robot or a world with dynamics.
    pub dynamic_profile: &'static Profile,

    /// Order of the joints in the legs.
    pub leg: LegGeometry,
    /// Time constants with which the joints of a leg follow their targets, s: hip yaw, roll and pitch, knee, ankle pitch and roll. The
    /// targets of a walk lead by them. `None` if the gait is tuned with the lag.
    pub leg_lags: Option<[f32; 6]>,
    /// Direction of the arms at zero.
    pub arm: ArmGeometry,
    /// What the robot measures.
    pub senses: Senses,
    /// Evidence with which a leg joint that rests beside its target is stuck: two for each cycle of 10 ms from 0.3 rad on if the torso
    /// is upright, one from 0.2 rad on if it is not. `None` if the ground may hold the joints of this robot longer, as in its get-ups.
    pub stuck_evidence: Option<u8>,
}

impl RobotModel {
    /// Mass of the whole robot, kg.
    #[must_use]
    pub const fn total_mass(&self) -> f32 {
        self.masses.total()
    }

    /// Current that a joint's motor bears continuously, A.
    #[must_use]
    pub const fn continuous_current(&self, joint: Joint) -> f32 {
        self.actuators.0[joint.index()].continuous_current()
    }

    /// Joints of a side's leg: hip yaw-pitch or hip yaw, hip roll, hip pitch, knee pitch, ankle pitch, ankle roll.
    #[must_use]
    pub fn leg_joints(&self, side: Side) -> [Joint; 6] {
        let mut joints = side.leg();
        if !self.leg.shares_hip_yaw() && side == Side::Right {
            joints[0] = Joint::RIGHT_HIP_YAW;
        }
        joints
    }

    /// Forward kinematics of a leg: poses of pelvis, hip, thigh, tibia, ankle and foot in the robot frame, from the angles
    /// of hip yaw-pitch, hip roll, hip pitch, knee pitch, ankle pitch and ankle roll.
    #[must_use]
    pub fn leg_poses(&self, side: Side, angles: [f32; 6]) -> [Affine3A; 6] {
        match &self.leg {
            LegGeometry::SharedYawPitch => leg::poses(self.dimensions, side, angles),
            LegGeometry::PitchRollYaw(leg) => leg.poses(side, self.dimensions.hip, angles),
        }
    }

    /// Inverse kinematics of a leg with a hip yaw-pitch of its own.
    ///
    /// `ankle` is the pose of the foot in the robot frame; its origin is the intersection of the ankle's axes. A place out
    /// of reach returns the straight (or most bent) leg in its direction. Joint limits are not applied. The formulas are
    /// singular at a hip roll of 45° inwards, and where the hip lies on the axis of the ankle roll.
    #[must_use]
    pub fn leg_angles(&self, side: Side, ankle: &Affine3A) -> LegAngles {
        match &self.leg {
            LegGeometry::SharedYawPitch => leg::angles(self.dimensions, side, ankle),
            LegGeometry::PitchRollYaw(leg) => leg.angles(side, self.dimensions.hip, ankle),
        }
    }

    /// Inverse kinematics of a leg with a given hip yaw-pitch, rad: place and normal of the sole are exact, its yaw follows.
    ///
    /// `ankle` and places out of reach as in [`leg_angles`](Self::leg_angles). A leg with a hip yaw of its own reaches the whole
    /// pose, whatever `hip_yaw_pitch` is.
    #[must_use]
    pub fn leg_angles_at(&self, side: Side, ankle: &Affine3A, hip_yaw_pitch: f32) -> LegAngles {
        match &self.leg {
            LegGeometry::SharedYawPitch => leg::angles_at(self.dimensions, side, ankle, hip_yaw_pitch),
            LegGeometry::PitchRollYaw(_) => self.leg_angles(side, ankle),
        }
    }
}

/// Models are equal if they have one name.
impl PartialEq for RobotModel {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Debug for RobotModel {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// Maximum of a [`FeedbackDelay`], control cycles.
pub const MAX_FEEDBACK_DELAY: usize = 4;

/// A number of control cycles from 1 to [`MAX_FEEDBACK_DELAY`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FeedbackDelay(usize);

impl FeedbackDelay {
    /// A delay of this many cycles.
    ///
    /// # Panics
    /// If the number is out of range; in a constant the compiler reports it.
    #[must_use]
    pub const fn new(cycles: usize) -> Self {
        assert!(cycles >= 1 && cycles <= MAX_FEEDBACK_DELAY, "a feedback delay has 1 to 4 control cycles");
        Self(cycles)
    }

    /// Number of control cycles.
    #[must_use]
    pub const fn cycles(self) -> usize {
        self.0
    }
}
