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

pub use simulated::SIMULATED;

use crate::joints::Joint;
use crate::model::{ArmGeometry, FallLimits, FeedbackDelay, HeadSpeed, LegGeometry, RobotModel, Senses};

/// The NAO H25 V6 of Aldebaran. Lengths and masses are valid for V4 and V5, too, except the head's mass.
pub const NAO: &RobotModel = &RobotModel {
    id: "nao",
    name: "NAO H25 V6",
    joints: &Joint::ALL,
    limits: &joints::LIMITS,
    max_speeds: &joints::MAX_SPEEDS,
    actuators: &actuators::ACTUATORS,
    // Source: B-Human 2015, team report, section 4.1.1.1.
    dead_time: 0.03,
    // Source: 36 ms, B-Human 2023 `walkingEngineCommon.cfg`.
    feedback_delay: FeedbackDelay::new(4),
    thermal: actuators::THERMAL,
    head_pitch_limits: &joints::HEAD_PITCH_LIMITS,
    // Source: HULKs 2025 `default.json`.
    head_speed: HeadSpeed { yaw: 3.0, pitch: 0.8 },
    dimensions: &dimensions::DIMENSIONS,
    camera_height: 0.48,
    body_shape: &shape::BODY_SHAPE,
    masses: &masses::MASSES,
    // Our choice: 57 % of the weight.
    support_force: 30.0,
    // Pitch: HULKs 2025. Roll: our choice; the maximum roll of the walk is 0.2 rad.
    fall_limits: FallLimits { backward_pitch: -0.4, forward_pitch: 0.6, roll: 0.5 },
    stiffness: &postures::STIFFNESS,
    stand: postures::STAND,
    sit: postures::SIT,
    // The minimum that does not tip over in `MuJoCo`, where it takes 1/15 of the motors' continuous torque.
    sit_stiffness: 0.1,
    to_stand: &postures::TO_STAND,
    to_sit: &postures::TO_SIT,
    get_up: &getup::GET_UP,
    fall_postures: &postures::FALL_POSTURES,
    kinematic_profile: &profiles::KINEMATIC,
    dynamic_profile: &profiles::DYNAMIC,
    leg: LegGeometry::SharedYawPitch,
    leg_lags: None,
    arm: ArmGeometry::Forward,
    senses: Senses::ALL,
    // A joint that the ground or an obstacle blocks has less than 80: 200 get-ups in MuJoCo, of which 120 beside goal posts, in the goal or
    // beside another robot.
    stuck_evidence: Some(100),
};
