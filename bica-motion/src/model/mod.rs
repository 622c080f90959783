//! Robot model: the properties of a humanoid that the algorithms of this crate need, as constants of a type.
//!
//! A robot is a zero-sized type that implements [`RobotModel`], for example [`Nao`]. The algorithms take it as a type
//! parameter and read its associated constants, so a compiled program contains only the numbers of its robot.
//!
//! A robot with other proportions, limits, masses, motors or tuned motions needs no change in this crate: implement the
//! trait and name the type, for example `Walk::<MyRobot>::new(&MyRobot::DYNAMIC_PROFILE.gait)`.
//!
//! # What a model must have
//! - Legs with six joints in the order hip yaw-pitch, hip roll, hip pitch, knee pitch, ankle pitch, ankle roll. One motor
//!   drives the hip yaw-pitch of both legs; its axis is tilted by 45°. A leg with another geometry of the same joints
//!   overrides [`leg_poses`](RobotModel::leg_poses), [`leg_angles`](RobotModel::leg_angles) and
//!   [`leg_angles_at`](RobotModel::leg_angles_at). Or legs with hip pitch, roll and yaw from the torso down, each with a motor
//!   of its own: [`LegGeometry::PitchRollYaw`].
//! - A head with yaw below pitch, and at most two cameras in it.
//! - Arms with shoulder pitch, shoulder roll, elbow yaw, elbow roll and wrist yaw. Missing arm joints are left out of
//!   [`JOINTS`](RobotModel::JOINTS); their angles are computed but not used. At zero they point ahead, or to the sides
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
pub use nao::Nao;
pub use pitch_first::{LegGeometry, PitchFirstLeg};
pub use posture::{FallPostures, symmetric};
pub use profile::Profile;
pub use range::Range;
pub use senses::Senses;
pub use stiffness::{LimbStiffness, StiffnessTable};
pub use t1::T1;

use core::fmt::Debug;

use glam::Affine3A;

use crate::joints::{Joint, Joints};
use crate::keyframes::Keyframe;
use crate::limbs::LegAngles;
use crate::side::Side;

/// A humanoid robot as data. See the [module](self) for what is covered.
///
/// Units are m, rad, s, kg, N, unless stated otherwise; x forward, y left, z up.
pub trait RobotModel: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Name of the robot.
    const NAME: &'static str;
    /// Joints that the robot has.
    const JOINTS: &'static [Joint];
    /// Range of each joint, independent of the other joints.
    const LIMITS: &'static Joints<Range>;
    /// Maximum speed of each joint, rad/s; a hand: 1/s.
    const MAX_SPEEDS: &'static Joints;
    /// Motor and gear of each joint.
    const ACTUATORS: &'static Joints<Actuator>;
    /// Time from a command to the first motion of a joint, s.
    const DEAD_TIME: f32;
    /// Time from a command until the measured angle follows it, in control cycles; at most [`MAX_FEEDBACK_DELAY`].
    const FEEDBACK_DELAY: usize;
    /// Thermal limits of the motors.
    const THERMAL: ThermalLimits;
    /// Pitch range of the head at several yaws, in ascending order of the yaw from 0. At least one.
    const HEAD_PITCH_LIMITS: &'static [HeadPitchLimit];
    /// Speed of the head at which camera images are not blurred.
    const HEAD_SPEED: HeadSpeed;
    /// Lengths, and places of the sensors.
    const DIMENSIONS: &'static Dimensions;
    /// Outer shape.
    const BODY_SHAPE: &'static BodyShape;
    /// Masses of all segments.
    const MASSES: &'static Masses;
    /// Minimum force on a foot that supports the robot alone, N.
    const SUPPORT_FORCE: f32;
    /// Torso angles within which the robot does not fall.
    const FALL_LIMITS: FallLimits;
    /// Stiffness of the joints.
    const STIFFNESS: &'static StiffnessTable;
    /// Posture from which motions begin and in which they end.
    const STAND: Joints;
    /// A crouch on flat feet that is stable with little force.
    const SIT: Joints;
    /// Minimum stiffness that holds [`SIT`](Self::SIT), 0 to 1.
    const SIT_STIFFNESS: f32;
    /// Motion from any posture near the stand to [`STAND`](Self::STAND).
    const TO_STAND: &'static [Keyframe];
    /// Motion from the stand to [`SIT`](Self::SIT).
    const TO_SIT: &'static [Keyframe];
    /// Key postures of getting up.
    const GET_UP: &'static GetUpFrames;
    /// Postures for a fall.
    const FALL_POSTURES: &'static FallPostures;
    /// Motions for a world without dynamics: quasi-static gait, no slip.
    const KINEMATIC_PROFILE: &'static Profile;
    /// Motions for a robot or a world with dynamics.
    const DYNAMIC_PROFILE: &'static Profile;

    /// Order of the joints in the legs.
    const LEG: LegGeometry = LegGeometry::SharedYawPitch;
    /// Time constants with which the joints of a leg follow their targets, s: hip yaw, roll and pitch, knee, ankle pitch and roll. The
    /// targets of a walk lead by them. `None` if the gait is tuned with the lag.
    const LEG_LAGS: Option<[f32; 6]> = None;
    /// Direction of the arms at zero.
    const ARM: ArmGeometry = ArmGeometry::Forward;
    /// What the robot measures.
    const SENSES: Senses = Senses::ALL;

    /// Mass of the whole robot, kg.
    const TOTAL_MASS: f32 = Self::MASSES.total();
    /// Current that each joint's motor bears continuously, A.
    const CONTINUOUS_CURRENTS: &'static Joints = &actuator::continuous_currents(Self::ACTUATORS);

    /// Joints of a side's leg: hip yaw-pitch or hip yaw, hip roll, hip pitch, knee pitch, ankle pitch, ankle roll.
    #[must_use]
    fn leg_joints(side: Side) -> [Joint; 6] {
        let mut joints = side.leg();
        if !Self::LEG.shares_hip_yaw() && side == Side::Right {
            joints[0] = Joint::RIGHT_HIP_YAW;
        }
        joints
    }

    /// Forward kinematics of a leg: poses of pelvis, hip, thigh, tibia, ankle and foot in the robot frame, from the angles
    /// of hip yaw-pitch, hip roll, hip pitch, knee pitch, ankle pitch and ankle roll.
    #[must_use]
    fn leg_poses(side: Side, angles: [f32; 6]) -> [Affine3A; 6] {
        match Self::LEG {
            LegGeometry::SharedYawPitch => leg::poses::<Self>(side, angles),
            LegGeometry::PitchRollYaw(leg) => leg.poses(side, Self::DIMENSIONS.hip, angles),
        }
    }

    /// Inverse kinematics of a leg with a hip yaw-pitch of its own.
    ///
    /// `ankle` is the pose of the foot in the robot frame; its origin is the intersection of the ankle's axes. A place out
    /// of reach returns the straight (or most bent) leg in its direction. Joint limits are not applied. The formulas are
    /// singular at a hip roll of 45° inwards, and where the hip lies on the axis of the ankle roll.
    #[must_use]
    fn leg_angles(side: Side, ankle: &Affine3A) -> LegAngles {
        match Self::LEG {
            LegGeometry::SharedYawPitch => leg::angles::<Self>(side, ankle),
            LegGeometry::PitchRollYaw(leg) => leg.angles(side, Self::DIMENSIONS.hip, ankle),
        }
    }

    /// Inverse kinematics of a leg with a given hip yaw-pitch, rad: place and normal of the sole are exact, its yaw follows.
    ///
    /// `ankle` and places out of reach as in [`leg_angles`](Self::leg_angles). A leg with a hip yaw of its own reaches the whole
    /// pose, whatever `hip_yaw_pitch` is.
    #[must_use]
    fn leg_angles_at(side: Side, ankle: &Affine3A, hip_yaw_pitch: f32) -> LegAngles {
        match Self::LEG {
            LegGeometry::SharedYawPitch => leg::angles_at::<Self>(side, ankle, hip_yaw_pitch),
            LegGeometry::PitchRollYaw(_) => Self::leg_angles(side, ankle),
        }
    }
}

/// Maximum of [`RobotModel::FEEDBACK_DELAY`], control cycles.
pub const MAX_FEEDBACK_DELAY: usize = 4;
