//! Booster K1: 22 joints, 19.7 kg.
//!
//! Sources: lengths, masses, ranges and torques from the model of the robot in PyPI's `rcsssmj` 0.2.1 (BSD-3-Clause), converted to
//! `models/k1/robot.xml`; camera angles from B-Human's release of 2025.

use glam::{Vec2, Vec3};

use crate::joints::{Joint, Joints};
use crate::keyframes::Keyframe;
use crate::model::booster::{self, each_joint};
use crate::model::booster_getup;
use crate::model::booster_kicks;
use crate::model::simulation::{Disc, Extents, Figure, MujocoModel, Paint, Part, SimulatedModel, Solid};
use crate::model::{
    ArmGeometry, BodyShape, CameraMount, Capsule, Dimensions, HeadPitchLimit, LegGeometry, Mass, Masses, Parameters,
    PitchFirstLeg, Profile, Range, RobotModel, SidewaysArm, T1, symmetric,
};
use crate::segment::Segment;
use crate::side::Side::Left;
use crate::velocity::Velocity;

/// The K1 of Booster Robotics. Its waist is rigid. What both robots share is stated for the T1.
pub const K1: &RobotModel = &RobotModel {
    id: "k1",
    name: "Booster K1",
    joints: &booster::JOINTS_WITHOUT_WAIST,
    limits: &each_joint!(limit),
    actuators: &booster::actuators(&TORQUE_LIMITS),
    head_pitch_limits: &[HeadPitchLimit::degrees(0.0, -20.0, 48.0)],
    dimensions: &DIMENSIONS,
    camera_height: 0.86,
    body_shape: &SHAPE,
    masses: &MASSES,
    support_force: 110.0,
    stand: STAND,
    to_stand: TO_STAND,
    get_up: &booster_getup::K1,
    kinematic_profile: &PROFILE,
    dynamic_profile: &PROFILE,
    leg: LegGeometry::PitchRollYaw(PitchFirstLeg {
        roll: Vec3::new(0.0, 0.0, -0.026),
        yaw: Vec3::new(0.012, 0.0, -0.0485),
        knee: Vec3::new(-0.014, 0.0, -0.117),
        ankle: Vec3::new(0.000_197_06, 0.0002, -0.245_19),
        ankle_roll: Vec3::new(0.0, 0.0, 0.0),
    }),
    leg_lags: Some([0.03, 0.05, 0.05, 0.0375, 0.015, 0.015]),
    arm: ArmGeometry::Sideways(SidewaysArm {
        biceps: Vec3::new(0.0025, 0.068, -0.0135),
        elbow: Vec3::new(0.0, 0.044_428, 0.0),
        forearm: Vec3::new(0.0, 0.1215, 0.0),
    }),
    ..*T1
};

const STAND: Joints = symmetric(0.0, booster::ARM, [0.0, 0.0, -22.596_243, 46.388_466, -23.792_225, 0.0]);

/// From sitting to standing.
const TO_STAND: &[Keyframe] = &[Keyframe { seconds: 1.0, posture: STAND, stiffness: 0.8 }];

const fn limit(joint: Joint) -> Range {
    let (min, max) = match joint {
        Joint::HeadPitch => (-0.349, 0.855),
        Joint::LShoulderPitch | Joint::RShoulderPitch => (-3.316, 1.22),
        Joint::LShoulderRoll => (-1.74, 1.57),
        Joint::RShoulderRoll => (-1.57, 1.74),
        Joint::LElbowYaw | Joint::RElbowYaw => (-2.27, 2.27),
        Joint::LElbowRoll => (-2.44, 0.0),
        Joint::RElbowRoll => (0.0, 2.44),
        Joint::LHipPitch | Joint::RHipPitch => (-3.0, 2.21),
        Joint::LHipRoll => (-0.4, 1.57),
        Joint::RHipRoll => (-1.57, 0.4),
        Joint::HeadYaw | Joint::LEFT_HIP_YAW | Joint::RIGHT_HIP_YAW => (-1.0, 1.0),
        Joint::LKneePitch | Joint::RKneePitch => (0.0, 2.23),
        Joint::LAnklePitch | Joint::RAnklePitch => (-0.87, 0.345),
        Joint::LAnkleRoll | Joint::RAnkleRoll => (-0.345, 0.345),
        _ => (0.0, 0.0),
    };
    Range { min, max }
}

/// Torque limit, Nm; source: see above.
const fn torque(joint: Joint) -> f32 {
    match joint {
        Joint::HeadYaw | Joint::HeadPitch => 6.0,
        Joint::LHipPitch | Joint::RHipPitch => 30.0,
        Joint::LHipRoll | Joint::RHipRoll => 35.0,
        Joint::LKneePitch | Joint::RKneePitch => 40.0,
        Joint::LEFT_HIP_YAW
        | Joint::RIGHT_HIP_YAW
        | Joint::LAnklePitch
        | Joint::RAnklePitch
        | Joint::LAnkleRoll
        | Joint::RAnkleRoll => 20.0,
        _ => 14.0,
    }
}

/// It has one camera, which has both names.
const CAMERA: CameraMount =
    CameraMount { position: Vec3::new(0.06, 0.0, 0.08), tilt: 0.0, focal: Vec2::new(0.412, 0.741) };

const DIMENSIONS: Dimensions = Dimensions {
    hip: Vec3::new(0.0, 0.096, 0.0),
    thigh: 0.1661,
    tibia: 0.245_19,
    foot_height: 0.038,
    neck: Vec3::new(0.0056, 0.0, 0.3249),
    shoulder: Vec3::new(0.0, 0.077, 0.2615),
    upper_arm: Vec3::new(0.0025, 0.112_428, -0.0135),
    lower_arm: Vec3::new(0.0, 0.1215, 0.0),
    hand: Vec3::new(0.0, 0.1, 0.0),
    torso: Vec3::new(0.0, 0.0, 0.077),
    inertial_unit: Vec3::new(0.0, 0.0, 0.077),
    top_camera: CAMERA,
    bottom_camera: CAMERA,
    mass_over_hips: 0.0,
    sole_outline: &SOLE,
    left_pressure: SOLE,
    right_pressure: SOLE,
};

/// Corners of the sole.
const SOLE: [Vec2; 4] =
    [Vec2::new(0.116, -0.035), Vec2::new(0.116, 0.035), Vec2::new(-0.064, 0.035), Vec2::new(-0.064, -0.035)];

const MASSES: Masses = Masses::symmetric(
    [
        Mass::grams(6500.0, -4.3392, -0.65534, 142.686),
        Mass::grams(300.0, -0.69503, -0.38527, -1.312),
        Mass::grams(700.0, 11.042, -0.92871, 80.698),
    ],
    [
        Mass::grams(500.0, -2.701, 62.383, -11.965),
        Mass::grams(90.0, 17.29, 18.221, -0.04329),
        Mass::grams(800.0, -0.3979, 72.617, -0.66218),
        Mass::grams(190.0, -1.5751, 84.637, 8.7033),
        Mass::grams(0.0, 0.0, 0.0, 0.0),
    ],
    [
        Mass::grams(690.0, -10.093, -1.9934, -24.713),
        Mass::grams(130.0, 23.585, 0.049, -24.996),
        Mass::grams(1650.0, -8.4744, -4.0494, -87.906),
        Mass::grams(1500.0, -0.81083, 3.1459, -109.22),
        Mass::grams(39.0, 0.0, 0.0, 0.0),
        Mass::grams(494.0, 11.662, 0.244, -14.364),
    ],
);

const PROFILE: Profile = Profile { gait: GAIT, kicks: booster_kicks::K1, odometry: booster::ODOMETRY };

/// Orders of magnitude from B-Human's walk of 2025, tuned in `MuJoCo`.
const GAIT: Parameters = Parameters {
    hip_height: 0.44,
    half_spacing: 0.096,
    torso_offset: 0.027,
    step_duration: 0.30,
    step_height: 0.027,
    pendulum_height: 0.514,
    max_speed_up: Velocity::new(0.03, 0.08, 0.4),
    velocity_drift: Velocity::new(0.02, 0.0, 0.0),
    velocity_scale: Velocity::new(1.0, 1.2, 1.05),
    contact_force: 40.0,
    ankle_pitch_gain: 0.042,
    ankle_roll_gain: 0.024,
    hip_roll_offset: 0.082,
    torso_pitch: -0.04,
    recovery_weights: [1.0, 0.04, 1.0],
    max_recovery_duration: 0.45,
    capture_deadband: Vec2::new(0.026, 0.0133),
    max_inward_step: 0.058,
    kick_min_distance: 0.15,
    kick_max_distance: 0.28,
    gyro_smoothing: 0.6,
    lag_compensation: 0.72,
    ankle_pitch_offset: 0.05,
    earliest_support_switch: 0.54,
    capture_sway: 0.015,
    ..booster::GAIT
};

/// Radii are our estimates.
const SHAPE: BodyShape = BodyShape {
    torso: [
        Capsule { from: [0.0, 0.0, 0.1], to: [0.0, 0.0, 0.26], radius: 0.07 },
        Capsule { from: [0.0, 0.07, 0.26], to: [0.0, -0.07, 0.26], radius: 0.07 },
    ],
    thigh: Capsule { from: [0.0; 3], to: KNEE, radius: 0.06 },
    tibia: Capsule { from: [0.0; 3], to: [0.0, 0.0, -0.245_19], radius: 0.05 },
    foot: [
        Capsule { from: [-0.064, -0.02, -0.01], to: [0.116, -0.02, -0.01], radius: 0.03 },
        Capsule { from: [-0.064, 0.02, -0.01], to: [0.116, 0.02, -0.01], radius: 0.03 },
    ],
    ..booster::SHAPE
};
const KNEE: [f32; 3] = [-0.014, 0.0, -0.117];

/// The robot in simulators.
pub const SIMULATED: &SimulatedModel = &SimulatedModel {
    robot: K1,
    extents: &Extents { sole_middle: 0.026, min_hip_height: 0.33, ..booster::EXTENTS },
    lying: &booster::LYING,
    figure: &Figure {
        trunk: &booster::TRUNK,
        side: &[
            booster::UPPER_ARM,
            booster::FOREARM,
            Part(Segment::Thigh(Left), Paint::Shell, Solid::Tube([[0.0; 3], KNEE], [0.06, 0.05])),
            Part(Segment::Tibia(Left), Paint::Shell, Solid::Tube([[0.0; 3], [0.0, 0.0, -0.245_19]], [0.05, 0.04])),
            Part(Segment::Foot(Left), Paint::Joint, Solid::Block([0.026, 0.0, -0.015], [0.09, 0.035, 0.015])),
        ],
        head: &booster::HEAD,
        foot_shadow: Disc { ahead: 0.026, radius: 0.15 },
    },
    thermal_ratings: K1.actuators,
    mujoco: MUJOCO,
};

const ROBOT: &str = include_str!("../../models/k1/robot.xml");
const TORQUE_LIMITS: Joints = each_joint!(torque);

const MUJOCO: MujocoModel = MujocoModel {
    robot: ROBOT,
    bystander: "<geom type=\"cylinder\" size=\"0.15 0.45\" pos=\"0 0 0.45\" material=\"team\" contype=\"8\" conaffinity=\"33\"/>",
    shells: ROBOT,
    gains: &booster::gains(400.0),
    torque_limits: &TORQUE_LIMITS,
    motors_damp: true,
    shadows: booster::SHADOWS,
};
