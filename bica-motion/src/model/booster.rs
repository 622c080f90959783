//! What Booster's robots have in common: order of the joints, motors, stiffness, postures, extents and looks.
//!
//! Booster publishes neither speeds nor thermal data of the motors: those are our estimates.

use glam::Vec2;

use crate::joints::{JOINTS, Joint, Joints};
use crate::keyframes::Keyframe;
use crate::model::simulation::{self, Disc, Extents, Lying, Paint, Part, Solid};
use crate::model::{
    Actuator, BodyShape, Calibration, Capsule, FallLimits, FallPostures, HeadSpeed, LimbStiffness, NAO, Parameters,
    Range, StiffnessTable, ThermalLimits, symmetric,
};
use crate::segment::Segment;
use crate::side::Side::Left;
use crate::velocity::Velocity;

/// A value for each joint, from a constant function of the joint.
macro_rules! each_joint {
    ($of:path) => {{
        let mut values = [$of(crate::joints::Joint::HeadYaw); crate::joints::JOINTS];
        let mut i = 0;
        while i < crate::joints::JOINTS {
            values[i] = $of(crate::joints::Joint::ALL[i]);
            i += 1;
        }
        crate::joints::Joints(values)
    }};
}
pub(super) use each_joint;

/// Soles whose slip hides an offset of the gyroscope: on the ground of the league's server a T1 turns by more than 0.2 rad/s beyond its
/// legs.
pub(super) const ODOMETRY: Calibration = Calibration { max_turn_difference: f32::INFINITY, ..Calibration::EXACT };

/// Joints of a robot with a waist.
pub(super) const JOINTS_WITH_WAIST: [Joint; 23] = {
    use Joint::{
        HeadPitch, HeadYaw, LAnklePitch, LAnkleRoll, LElbowRoll, LElbowYaw, LHipPitch, LHipRoll, LKneePitch,
        LShoulderPitch, LShoulderRoll, RAnklePitch, RAnkleRoll, RElbowRoll, RElbowYaw, RHipPitch, RHipRoll, RKneePitch,
        RShoulderPitch, RShoulderRoll,
    };
    [
        HeadYaw,
        HeadPitch,
        LShoulderPitch,
        LShoulderRoll,
        LElbowYaw,
        LElbowRoll,
        RShoulderPitch,
        RShoulderRoll,
        RElbowYaw,
        RElbowRoll,
        LHipPitch,
        LHipRoll,
        Joint::LEFT_HIP_YAW,
        LKneePitch,
        LAnklePitch,
        LAnkleRoll,
        RHipPitch,
        RHipRoll,
        Joint::RIGHT_HIP_YAW,
        RKneePitch,
        RAnklePitch,
        RAnkleRoll,
        Joint::WAIST_YAW,
    ]
};
/// Joints of a robot with a rigid waist.
pub(super) const JOINTS_WITHOUT_WAIST: [Joint; 22] = *JOINTS_WITH_WAIST.first_chunk().unwrap();

/// Hanging arms, degrees.
pub(super) const ARM: [f32; 5] = [0.0, -83.0, 0.0, -5.729_578, 0.0];
pub(super) const SIT: Joints = symmetric(0.0, ARM, [0.0, 0.0, -50.0, 95.0, -45.0, 0.0]);
pub(super) const MAX_SPEEDS: Joints = Joints([12.0; JOINTS]);
pub(super) const THERMAL: ThermalLimits = ThermalLimits {
    temperature: Range { min: 75.0, max: 85.0 },
    load: Range { min: 3.0, max: 4.0 },
    derated_stiffness: 0.7,
};
pub(super) const HEAD_SPEED: HeadSpeed = HeadSpeed { yaw: 3.0, pitch: 1.0 };
pub(super) const FALL_LIMITS: FallLimits = FallLimits { backward_pitch: -0.6, forward_pitch: 0.7, roll: 0.6 };

const FIRM: LimbStiffness =
    LimbStiffness { head: 1.0, shoulder_pitch: 1.0, shoulder_roll: 1.0, elbow: 1.0, wrist: 0.0, leg: 1.0 };
const LIMP: LimbStiffness =
    LimbStiffness { head: 0.3, shoulder_pitch: 0.2, shoulder_roll: 0.2, elbow: 0.2, wrist: 0.0, leg: 0.1 };
pub(super) const STIFFNESS: StiffnessTable = StiffnessTable { stand: FIRM, walk: FIRM, fall: LIMP };

const BRACE: Keyframe = Keyframe { seconds: 0.4, posture: SIT, stiffness: 0.2 };
pub(super) const FALL_POSTURES: FallPostures = FallPostures { front: BRACE, other: BRACE };

/// Position gains, Nm/rad, with that of the legs as B-Human's for its walk.
pub(super) const fn gains(leg: f32) -> Joints {
    let mut gains = [leg; JOINTS];
    let mut i = 0;
    while i < JOINTS {
        gains[i] = match Joint::ALL[i] {
            Joint::HeadYaw | Joint::HeadPitch => 20.0,
            Joint::WAIST_YAW => 300.0,
            Joint::LShoulderPitch
            | Joint::LShoulderRoll
            | Joint::LElbowYaw
            | Joint::LElbowRoll
            | Joint::LWristYaw
            | Joint::RShoulderPitch
            | Joint::RShoulderRoll
            | Joint::RElbowYaw
            | Joint::RElbowRoll
            | Joint::RWristYaw => 40.0,
            _ => leg,
        };
        i += 1;
    }
    Joints(gains)
}

/// Motors with these peak torques, Nm, a gear of 20 and a third of the peak torque continuously: our estimates.
pub(super) const fn actuators(peaks: &Joints) -> Joints<Actuator> {
    let mut actuators = [motor(1.0); JOINTS];
    let mut i = 0;
    while i < JOINTS {
        actuators[i] = motor(peaks.0[i]);
        i += 1;
    }
    Joints(actuators)
}

const fn motor(peak: f32) -> Actuator {
    let torque = peak / (20.0 * 0.9);
    Actuator {
        voltage: 48.0,
        no_load_speed: 20.0 * 12.0,
        stall_torque: 2.0 * torque,
        continuous_torque: torque / 3.0,
        gear_ratio: 20.0,
        gear_efficiency: 0.9,
    }
}

/// What both gaits share.
pub(super) const GAIT: Parameters = Parameters {
    max_velocity: Velocity::new(0.7, 0.35, 1.0),
    max_backward_speed: 0.35,
    max_slow_down: Velocity::new(0.2, 0.15, 0.8),
    toe_distance: 0.12,
    kick_hip_roll_offset: 0.05,
    expected_knee_sag: 0.1,
    sag_hip_gain: 0.0,
    sag_knee_gain: 0.0,
    min_recovery_duration: 0.2,
    max_capture_step: Vec2::new(0.3, 0.2),
    max_capture_speed: 2.0,
    reported_capture_step: 0.06,
    kick_swing: 0.16,
    kick_lateral_tolerance: 0.05,
    arm_swing_gain: 2.0,
    ..NAO.dynamic_profile.gait
};

/// Arms; trunk and legs are each robot's own. Radii are our estimates.
pub(super) const SHAPE: BodyShape = BodyShape {
    biceps: [
        Capsule { from: [0.0; 3], to: [0.0, 0.05, 0.0], radius: 0.045 },
        Capsule { from: [0.0, 0.05, 0.0], to: [0.0, 0.15, 0.0], radius: 0.04 },
    ],
    forearm: Capsule { from: [0.0; 3], to: [0.0, 0.2, 0.0], radius: 0.035 },
    ..*NAO.body_shape
};

/// Extents; sole and hips are each robot's own.
pub(super) const EXTENTS: Extents = Extents {
    standing: 0.25,
    lying: 0.7,
    torso: 0.15,
    foot_front: Disc { ahead: 0.05, radius: 0.09 },
    foot_height: 0.05,
    sole_middle: 0.0,
    leg: Disc { ahead: 0.01, radius: 0.1 },
    trunk_length: 0.4,
    trunk_radius: 0.12,
    min_hip_height: 0.0,
};
pub(super) const LYING: Lying =
    Lying { fall_length: 0.45, front_height: 0.12, back_height: 0.12, side_height: 0.16, ..*simulation::NAO.lying };
pub(super) const TRUNK: [Part; 1] =
    [Part(Segment::Torso, Paint::Team, Solid::Block([0.0, 0.0, 0.235], [0.075, 0.1, 0.15]))];
pub(super) const UPPER_ARM: Part =
    Part(Segment::Elbow(Left), Paint::Shell, Solid::Tube([[0.0; 3], [0.0, 0.12, 0.0]], [0.03, 0.03]));
pub(super) const FOREARM: Part =
    Part(Segment::Forearm(Left), Paint::Shell, Solid::Tube([[0.0; 3], [0.0, 0.2, 0.0]], [0.03, 0.03]));
pub(super) const HEAD: [Part; 1] = [Part(Segment::Head, Paint::Shell, Solid::Sphere([0.01, 0.0, 0.1], 0.08))];
pub(super) const SHADOWS: [Vec2; 2] = [Vec2::new(0.15, 0.08), Vec2::new(0.2, 0.2)];
