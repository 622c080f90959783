//! Second robot model: taller and heavier than the NAO, with other leg proportions, limits, speeds and motors.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kick::Kicks;
use bica_motion::model::simulation::{self, Disc, Extents, Figure, Lying, Paint, Part, SimulatedModel, Solid};
use bica_motion::model::{
    Actuator, CameraMount, Dimensions, FallLimits, HeadPitchLimit, HeadSpeed, KickFrame, Mass, Masses, NAO, Parameters,
    Profile, Range, RobotModel, Technique, ThermalLimits, symmetric,
};
use bica_motion::segment::Segment;
use bica_motion::walk::Velocity;
use glam::{Vec2, Vec3};

/// Length relative to the NAO, except that of thigh and tibia.
const SCALE: f32 = 1.5;

/// A humanoid of 0.87 m and 21 kg. What is not listed is as on the NAO.
pub(crate) const ROBOT: &RobotModel = &RobotModel {
    id: "tall",
    name: "tall humanoid of the tests",
    limits: &LIMITS,
    max_speeds: &Joints([5.5; 25]),
    actuators: &Joints([MOTOR; 25]),
    dead_time: 0.02,
    thermal: ThermalLimits {
        temperature: Range { min: 80.0, max: 90.0 },
        load: Range { min: 2.0, max: 2.5 },
        derated_stiffness: 0.5,
    },
    head_pitch_limits: &[HeadPitchLimit::degrees(0.0, -20.0, 40.0), HeadPitchLimit::degrees(90.0, -10.0, 20.0)],
    head_speed: HeadSpeed { yaw: 2.0, pitch: 1.0 },
    dimensions: &Dimensions {
        hip: Vec3::new(0.0, 0.075, 0.0),
        thigh: 0.17,
        tibia: 0.14,
        foot_height: 0.07,
        neck: Vec3::new(0.01, 0.0, 0.32),
        shoulder: Vec3::new(0.0, 0.15, 0.28),
        upper_arm: Vec3::new(0.16, 0.02, 0.0),
        lower_arm: Vec3::new(0.09, 0.0, 0.0),
        hand: Vec3::new(0.08, 0.0, 0.0),
        torso: Vec3::new(0.0, 0.0, 0.1),
        inertial_unit: Vec3::new(0.0, 0.0, 0.15),
        top_camera: CameraMount { position: Vec3::new(0.08, 0.0, 0.1), tilt: 0.0, focal: Vec2::new(0.9, 1.2) },
        bottom_camera: CameraMount { position: Vec3::new(0.07, 0.0, 0.02), tilt: 0.5, focal: Vec2::new(0.9, 1.2) },
        mass_over_hips: 0.05,
        sole_outline: &SOLE,
        left_pressure: PRESSURE,
        right_pressure: PRESSURE,
    },
    masses: &MASSES,
    fall_limits: FallLimits { backward_pitch: -0.3, forward_pitch: 0.45, roll: 0.4 },
    stand: STAND,
    kinematic_profile: &PROFILE,
    dynamic_profile: &PROFILE,
    ..*NAO
};

const STAND: Joints =
    symmetric(0.0, [90.0, 6.990_085, 0.0, -5.729_578, 0.0], [0.0, 0.0, -27.428_39, 70.894_04, -43.465_65, 0.0]);

/// Limits of the legs are narrower than the NAO's, except those of the knees.
const LIMITS: Joints<Range> = {
    let mut limits = NAO.limits.0;
    limits[Joint::HeadYaw.index()] = Range::degrees(-90.0, 90.0);
    limits[Joint::HeadPitch.index()] = Range::degrees(-20.0, 40.0);
    limits[Joint::LHipYawPitch.index()] = Range::degrees(-40.0, 30.0);
    limits[Joint::LHipRoll.index()] = Range::degrees(-20.0, 35.0);
    limits[Joint::RHipRoll.index()] = Range::degrees(-35.0, 20.0);
    limits[Joint::LHipPitch.index()] = Range::degrees(-70.0, 20.0);
    limits[Joint::RHipPitch.index()] = Range::degrees(-70.0, 20.0);
    limits[Joint::LKneePitch.index()] = Range::degrees(0.0, 130.0);
    limits[Joint::RKneePitch.index()] = Range::degrees(0.0, 130.0);
    limits[Joint::LAnklePitch.index()] = Range::degrees(-65.0, 40.0);
    limits[Joint::RAnklePitch.index()] = Range::degrees(-65.0, 40.0);
    limits[Joint::LAnkleRoll.index()] = Range::degrees(-22.0, 35.0);
    limits[Joint::RAnkleRoll.index()] = Range::degrees(-35.0, 22.0);
    Joints(limits)
};

const MOTOR: Actuator = Actuator {
    voltage: 24.0,
    no_load_speed: 600.0,
    stall_torque: 0.3,
    continuous_torque: 0.08,
    gear_ratio: 100.0,
    gear_efficiency: 0.7,
};

/// Sole: a rectangle with the extents of the NAO's sole times `SCALE`.
const SOLE: [Vec2; 4] =
    [Vec2::new(0.15, -0.058), Vec2::new(0.15, 0.077), Vec2::new(-0.08, 0.077), Vec2::new(-0.08, -0.058)];

const PRESSURE: [Vec2; 4] =
    [Vec2::new(0.1, 0.04), Vec2::new(0.1, -0.04), Vec2::new(-0.04, 0.04), Vec2::new(-0.04, -0.04)];

pub(crate) const TALL: &SimulatedModel = &SimulatedModel {
    robot: ROBOT,
    extents: &Extents {
        standing: 0.22,
        lying: 0.6,
        torso: 0.14,
        foot_front: Disc { ahead: 0.05, radius: 0.1 },
        foot_height: 0.07,
        sole_middle: 0.035,
        leg: Disc { ahead: 0.03, radius: 0.1 },
        trunk_length: 0.38,
        trunk_radius: 0.14,
        min_hip_height: 0.22,
    },
    lying: &Lying {
        fall_length: 0.33,
        front_height: 0.12,
        back_height: 0.13,
        side_height: 0.16,
        ..*simulation::NAO.lying
    },
    figure: &Figure {
        trunk: &[Part(Segment::Torso, Paint::Shell, Solid::Block([0.0, 0.0, 0.2], [0.08, 0.12, 0.3]))],
        side: &[],
        head: &[],
        foot_shadow: Disc { ahead: 0.03, radius: 0.18 },
    },
    thermal_ratings: ROBOT.actuators,
    ..*simulation::NAO
};

const MASSES: Masses = Masses::symmetric(
    [Mass::grams(5000.0, -6.0, 0.0, 190.0), Mass::grams(300.0, 0.0, 0.0, -40.0), Mass::grams(2000.0, 5.0, 0.0, 80.0)],
    [
        Mass::grams(300.0, 0.0, -30.0, 0.0),
        Mass::grams(500.0, 40.0, 5.0, 0.0),
        Mass::grams(200.0, -20.0, 0.0, 0.0),
        Mass::grams(300.0, 40.0, 0.0, 0.0),
        Mass::grams(200.0, 40.0, 0.0, 0.0),
    ],
    [
        Mass::grams(300.0, -10.0, -15.0, 40.0),
        Mass::grams(600.0, -20.0, 0.0, -8.0),
        Mass::grams(1600.0, 2.0, 3.0, -80.0),
        Mass::grams(1200.0, 6.0, 3.0, -70.0),
        Mass::grams(600.0, 0.0, 0.0, 10.0),
        Mass::grams(800.0, 35.0, 5.0, -50.0),
    ],
);

/// The NAO's quasi-static gait and front kick, with all lengths scaled.
const PROFILE: Profile = Profile {
    gait: Parameters {
        hip_height: 0.3225,
        half_spacing: SCALE * 0.05,
        torso_offset: SCALE * 0.012,
        lateral_duration_gain: -0.40 / SCALE,
        step_height: SCALE * 0.008,
        mid_step_hip_offset: SCALE * 0.021,
        single_support_hip_offset: SCALE * 0.031,
        lean_gain: 3.3 / SCALE,
        max_sway_speed: SCALE * 0.6,
        max_velocity: Velocity::new(0.3, 0.14, 0.9),
        max_backward_speed: 0.2,
        max_speed_up: Velocity::new(0.1, 0.07, 0.5),
        max_slow_down: Velocity::new(0.2, 0.14, 1.0),
        toe_distance: 0.15,
        contact_force: 12.0,
        arm_swing_gain: 6.0 / SCALE,
        ..NAO.kinematic_profile.gait
    },
    kicks: Kicks { front: Technique { ball: Vec2::new(0.255, 0.09), frames: &FRONT }, ..NAO.kinematic_profile.kicks },
    odometry: NAO.kinematic_profile.odometry,
};

const FRONT: [KickFrame; 7] = {
    let mut frames = [NAO.kinematic_profile.kicks.front.frames[0]; 7];
    let mut i = 0;
    while i < frames.len() {
        let KickFrame { duration, pose } = NAO.kinematic_profile.kicks.front.frames[i];
        let (hips, foot) = (pose.hips, pose.foot);
        frames[i] = KickFrame::new(
            1.3 * duration,
            [SCALE * hips.x, SCALE * hips.y, SCALE * hips.z],
            [SCALE * foot.x, SCALE * foot.y, SCALE * foot.z],
            [pose.yaw, pose.roll, pose.pitch],
        );
        i += 1;
    }
    frames
};
