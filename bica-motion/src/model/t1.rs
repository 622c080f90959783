//! Booster T1: 23 joints, 31.6 kg.
//!
//! Sources: lengths, masses, ranges and torques from the model of the robot in PyPI's `rcsssmj` 0.2.1 (Apache-2.0), converted to
//! `models/t1/robot.xml`; camera angles from B-Human's release of 2025.

use glam::{Vec2, Vec3};

use crate::joints::{Joint, Joints};
use crate::keyframes::Keyframe;
use crate::model::booster::{self, each_joint};
use crate::model::booster_getup;
use crate::model::booster_kicks;
use crate::model::simulation::{Disc, Extents, Figure, MujocoModel, Paint, Part, SimulatedModel, Solid};
use crate::model::{
    ArmGeometry, BodyShape, CameraMount, Capsule, Dimensions, FeedbackDelay, HeadPitchLimit, LegGeometry, Mass, Masses,
    Parameters, PitchFirstLeg, Profile, Range, RobotModel, Senses, SidewaysArm, symmetric,
};
use crate::segment::Segment;
use crate::side::Side::Left;
use crate::velocity::Velocity;

/// The T1 of Booster Robotics. It has a waist, which motions keep straight.
pub const T1: &RobotModel = &RobotModel {
    id: "t1",
    name: "Booster T1",
    joints: &booster::JOINTS_WITH_WAIST,
    limits: &each_joint!(limit),
    max_speeds: &booster::MAX_SPEEDS,
    actuators: &booster::actuators(&TORQUE_LIMITS),
    // Our estimate; in the league's server a command acts one cycle later.
    dead_time: 0.01,
    feedback_delay: FeedbackDelay::new(2),
    thermal: booster::THERMAL,
    head_pitch_limits: &[HeadPitchLimit::degrees(0.0, -20.0, 69.0)],
    head_speed: booster::HEAD_SPEED,
    dimensions: &DIMENSIONS,
    camera_height: 1.08,
    body_shape: &SHAPE,
    masses: &MASSES,
    support_force: 180.0,
    fall_limits: booster::FALL_LIMITS,
    stiffness: &booster::STIFFNESS,
    stand: STAND,
    sit: booster::SIT,
    sit_stiffness: 0.3,
    to_stand: TO_STAND,
    to_sit: TO_SIT,
    get_up: &booster_getup::T1,
    fall_postures: &booster::FALL_POSTURES,
    kinematic_profile: &PROFILE,
    dynamic_profile: &PROFILE,
    leg: LegGeometry::PitchRollYaw(PitchFirstLeg {
        roll: Vec3::new(0.0, 0.0, -0.02),
        yaw: Vec3::new(0.0, 0.0, -0.081_854),
        knee: Vec3::new(-0.014, 0.0, -0.134),
        ankle: Vec3::new(0.0, 0.0, -0.28),
        ankle_roll: Vec3::new(0.0, 0.000_25, -0.012),
    }),
    leg_lags: Some([0.0218, 0.0364, 0.0364, 0.0273, 0.0109, 0.0109]),
    arm: ArmGeometry::Sideways(SidewaysArm {
        biceps: Vec3::new(0.0, 0.047, 0.0),
        elbow: Vec3::new(0.000_25, 0.0605, 0.0),
        forearm: Vec3::new(0.0, 0.1471, 0.0),
    }),
    senses: Senses::NONE,
    // In 2 of 48 get-ups in MuJoCo the ground held a hip roll until the evidence was 100.
    stuck_evidence: None,
};

/// The stand of the gait in the simulation league; the feet are 14 mm nearer to the middle than in that of `MuJoCo`.
const STAND: Joints = symmetric(0.0, booster::ARM, [0.0, 0.0, -27.669_054, 47.964_893, -20.295_845, 0.0]);

/// From sitting to standing.
const TO_STAND: &[Keyframe] = &[Keyframe { seconds: 1.0, posture: STAND, stiffness: 0.8 }];
/// From standing to sitting.
const TO_SIT: &[Keyframe] = &[Keyframe { seconds: 2.0, posture: booster::SIT, stiffness: 0.8 }];

const fn limit(joint: Joint) -> Range {
    let (min, max) = match joint {
        Joint::HeadYaw | Joint::WAIST_YAW => (-1.57, 1.57),
        Joint::HeadPitch => (-0.35, 1.22),
        Joint::LShoulderPitch | Joint::RShoulderPitch => (-3.31, 1.22),
        Joint::LShoulderRoll => (-1.74, 1.57),
        Joint::RShoulderRoll => (-1.57, 1.74),
        Joint::LElbowYaw | Joint::RElbowYaw => (-2.27, 2.27),
        Joint::LElbowRoll => (-2.44, 0.0),
        Joint::RElbowRoll => (0.0, 2.44),
        Joint::LHipPitch | Joint::RHipPitch => (-1.8, 1.57),
        Joint::LHipRoll => (-0.2, 1.57),
        Joint::RHipRoll => (-1.57, 0.2),
        Joint::LEFT_HIP_YAW | Joint::RIGHT_HIP_YAW => (-1.0, 1.0),
        Joint::LKneePitch | Joint::RKneePitch => (0.0, 2.34),
        Joint::LAnklePitch | Joint::RAnklePitch => (-0.87, 0.35),
        Joint::LAnkleRoll | Joint::RAnkleRoll => (-0.44, 0.44),
        _ => (0.0, 0.0),
    };
    Range { min, max }
}

/// Torque limit, Nm; source: see above.
const fn torque(joint: Joint) -> f32 {
    match joint {
        Joint::HeadYaw | Joint::HeadPitch => 7.0,
        Joint::LHipPitch | Joint::RHipPitch => 45.0,
        Joint::LHipRoll | Joint::RHipRoll | Joint::LEFT_HIP_YAW | Joint::RIGHT_HIP_YAW | Joint::WAIST_YAW => 30.0,
        Joint::LKneePitch | Joint::RKneePitch => 60.0,
        Joint::LAnklePitch | Joint::RAnklePitch => 20.0,
        Joint::LAnkleRoll | Joint::RAnkleRoll => 15.0,
        _ => 18.0,
    }
}

/// It has one camera, which has both names.
const CAMERA: CameraMount =
    CameraMount { position: Vec3::new(0.05, 0.0, 0.12), tilt: 0.0, focal: Vec2::new(0.604, 0.806) };

const DIMENSIONS: Dimensions = Dimensions {
    hip: Vec3::new(0.0, 0.106, 0.0),
    thigh: 0.2163,
    tibia: 0.28,
    foot_height: 0.03,
    neck: Vec3::new(0.0, 0.0, 0.420_35),
    shoulder: Vec3::new(-0.005, 0.1063, 0.3345),
    upper_arm: Vec3::new(0.000_25, 0.1075, 0.0),
    lower_arm: Vec3::new(0.0, 0.1471, 0.0),
    hand: Vec3::new(0.0, 0.13, 0.0),
    torso: Vec3::new(-0.0625, 0.0, 0.1155),
    inertial_unit: Vec3::new(-0.0625, 0.0, 0.1155),
    top_camera: CAMERA,
    bottom_camera: CAMERA,
    mass_over_hips: 0.039,
    sole_outline: &SOLE,
    left_pressure: SOLE,
    right_pressure: SOLE,
};

/// Corners of the sole.
const SOLE: [Vec2; 4] =
    [Vec2::new(0.1215, -0.05), Vec2::new(0.1215, 0.05), Vec2::new(-0.1015, 0.05), Vec2::new(-0.1015, -0.05)];

const MASSES: Masses = Masses::symmetric(
    [
        Mass::grams(14281.0, -5.6199, 0.0, 182.019),
        Mass::grams(443.91, -0.508, -1.403, -4.418),
        Mass::grams(631.019, 7.802, 1.262, 98.631),
    ],
    [
        Mass::grams(530.0, -0.677, 44.974, 0.0),
        Mass::grams(160.0, 3.862, 37.976, 0.0),
        Mass::grams(1020.0, 0.0, 85.353, -0.099),
        Mass::grams(327.214, -0.108, 109.573, 0.591),
        Mass::grams(0.0, 0.0, 0.0, 0.0),
    ],
    [
        Mass::grams(1021.0, 0.534, -7.296, -18.083),
        Mass::grams(385.0, 1.101, 0.024, -53.75),
        Mass::grams(2166.0, -7.233, 0.206, -89.184),
        Mass::grams(1730.0, -6.012, 0.259, -124.318),
        Mass::grams(73.0, -3.722, 0.0, -7.981),
        Mass::grams(685.0, -0.249, 0.0, -9.14),
    ],
);

const PROFILE: Profile = Profile { gait: GAIT, kicks: booster_kicks::T1, odometry: booster::ODOMETRY };

/// Orders of magnitude from B-Human's walk of 2025, tuned in `MuJoCo`.
const GAIT: Parameters = Parameters {
    hip_height: 0.52,
    half_spacing: 0.12,
    torso_offset: 0.004,
    step_duration: 0.33,
    start_shift: 0.03,
    step_height: 0.052,
    pendulum_height: 0.59,
    max_speed_up: Velocity::new(0.055, 0.08, 0.4),
    velocity_drift: Velocity::new(0.07, 0.0, 0.0),
    velocity_scale: Velocity::new(0.92, 1.13, 1.0),
    contact_force: 60.0,
    ankle_pitch_gain: 0.04,
    gyro_smoothing: 0.5,
    ankle_roll_gain: 0.046,
    hip_roll_offset: 0.029,
    torso_pitch: -0.05,
    recovery_weights: [1.0, 0.02, 4.0],
    max_recovery_duration: 0.50,
    capture_deadband: Vec2::new(0.022, 0.012),
    max_inward_step: 0.046,
    kick_min_distance: 0.17,
    kick_max_distance: 0.31,
    lag_compensation: 0.31,
    ankle_pitch_offset: -0.011,
    earliest_support_switch: 0.77,
    capture_sway: 0.0,
    velocity_smoothing: Some(0.7),
    capture_offset: Vec2::new(0.0365, -0.012),
    ..booster::GAIT
};

/// Radii are our estimates.
const SHAPE: BodyShape = BodyShape {
    torso: [
        Capsule { from: [0.0, 0.0, 0.1], to: [0.0, 0.0, 0.33], radius: 0.09 },
        Capsule { from: [0.0, 0.09, 0.33], to: [0.0, -0.09, 0.33], radius: 0.09 },
    ],
    thigh: Capsule { from: [0.0; 3], to: KNEE, radius: 0.06 },
    tibia: Capsule { from: [0.0; 3], to: [0.0, 0.0, -0.28], radius: 0.05 },
    foot: [
        Capsule { from: [-0.1015, -0.02, -0.01], to: [0.1215, -0.02, -0.01], radius: 0.03 },
        Capsule { from: [-0.1015, 0.02, -0.01], to: [0.1215, 0.02, -0.01], radius: 0.03 },
    ],
    ..booster::SHAPE
};
const KNEE: [f32; 3] = [-0.014, 0.0, -0.134];

/// The robot in simulators.
pub const SIMULATED: &SimulatedModel = &SimulatedModel {
    robot: T1,
    extents: &Extents { sole_middle: 0.01, min_hip_height: 0.4, ..booster::EXTENTS },
    lying: &booster::LYING,
    figure: &Figure {
        trunk: &booster::TRUNK,
        side: &[
            booster::UPPER_ARM,
            booster::FOREARM,
            Part(Segment::Thigh(Left), Paint::Shell, Solid::Tube([[0.0; 3], KNEE], [0.06, 0.05])),
            Part(Segment::Tibia(Left), Paint::Shell, Solid::Tube([[0.0; 3], [0.0, 0.0, -0.28]], [0.05, 0.04])),
            Part(Segment::Foot(Left), Paint::Joint, Solid::Block([0.01, 0.0, -0.015], [0.1115, 0.05, 0.015])),
        ],
        head: &booster::HEAD,
        foot_shadow: Disc { ahead: 0.01, radius: 0.15 },
    },
    thermal_ratings: T1.actuators,
    mujoco: MUJOCO,
};

const ROBOT: &str = include_str!("../../models/t1/robot.xml");
const TORQUE_LIMITS: Joints = each_joint!(torque);

const MUJOCO: MujocoModel = MujocoModel {
    robot: ROBOT,
    bystander: "<geom type=\"cylinder\" size=\"0.15 0.55\" pos=\"0 0 0.55\" material=\"team\" contype=\"8\" conaffinity=\"33\"/>",
    shells: ROBOT,
    gains: &booster::gains(550.0),
    torque_limits: &TORQUE_LIMITS,
    motors_damp: true,
    shadows: booster::SHADOWS,
};
