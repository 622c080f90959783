//! NAO H25 V6.

mod actuators;
mod dimensions;
mod gait;
mod getup;
mod joints;
mod kick_dynamic;
mod kick_kinematic;
mod masses;
mod mujoco;
mod postures;
mod profiles;
mod shape;
mod simulated;

use crate::joints::{Joint, Joints};
use crate::keyframes::Keyframe;
use crate::model::{
    Actuator, BodyShape, Dimensions, FallLimits, FallPostures, GetUpFrames, HeadPitchLimit, HeadSpeed, Masses, Profile,
    Range, RobotModel, StiffnessTable, ThermalLimits,
};

/// The NAO H25 V6 of Aldebaran. Lengths and masses are valid for V4 and V5, too, except the head's mass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Nao;

impl RobotModel for Nao {
    const NAME: &'static str = "NAO H25 V6";
    const JOINTS: &'static [Joint] = &Joint::ALL;
    const LIMITS: &'static Joints<Range> = &joints::LIMITS;
    const MAX_SPEEDS: &'static Joints = &joints::MAX_SPEEDS;
    const ACTUATORS: &'static Joints<Actuator> = &actuators::ACTUATORS;
    /// Source: B-Human 2015, team report, section 4.1.1.1.
    const DEAD_TIME: f32 = 0.03;
    /// Source: 36 ms, B-Human 2023 `walkingEngineCommon.cfg`.
    const FEEDBACK_DELAY: usize = 4;
    const THERMAL: ThermalLimits = actuators::THERMAL;
    const HEAD_PITCH_LIMITS: &'static [HeadPitchLimit] = &joints::HEAD_PITCH_LIMITS;
    /// Source: HULKs 2025 `default.json`.
    const HEAD_SPEED: HeadSpeed = HeadSpeed { yaw: 3.0, pitch: 0.8 };
    const DIMENSIONS: &'static Dimensions = &dimensions::DIMENSIONS;
    const BODY_SHAPE: &'static BodyShape = &shape::BODY_SHAPE;
    const MASSES: &'static Masses = &masses::MASSES;
    /// Our choice: 57 % of the weight.
    const SUPPORT_FORCE: f32 = 30.0;
    /// Pitch: HULKs 2025. Roll: our choice; the maximum roll of the walk is 0.2 rad.
    const FALL_LIMITS: FallLimits = FallLimits { backward_pitch: -0.4, forward_pitch: 0.6, roll: 0.5 };
    const STIFFNESS: &'static StiffnessTable = &postures::STIFFNESS;
    const STAND: Joints = postures::STAND;
    const SIT: Joints = postures::SIT;
    /// The minimum that does not tip over in `MuJoCo`, where it takes 1/15 of the motors' continuous torque.
    const SIT_STIFFNESS: f32 = 0.1;
    const TO_STAND: &'static [Keyframe] = &postures::TO_STAND;
    const TO_SIT: &'static [Keyframe] = &postures::TO_SIT;
    const GET_UP: &'static GetUpFrames = &getup::GET_UP;
    const FALL_POSTURES: &'static FallPostures = &postures::FALL_POSTURES;
    const KINEMATIC_PROFILE: &'static Profile = &profiles::KINEMATIC;
    const DYNAMIC_PROFILE: &'static Profile = &profiles::DYNAMIC;
}
