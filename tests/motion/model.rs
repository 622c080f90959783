//! The algorithms with a second robot model, and the tables of the NAO.

use bica_motion::fall::{FallDetector, FallState};
use bica_motion::head::{HeadAngles, look_at, pitch_range};
use bica_motion::health::{Fault, Health};
use bica_motion::joints::{Joint, Joints};
use bica_motion::kick::{Kick, KickMotion};
use bica_motion::kinematics::{self, Skeleton};
use bica_motion::model::simulation::{HUMANOIDS, humanoid};
use bica_motion::model::{NAO, RobotModel};
use bica_motion::odometry::{MotionInput, Odometry};
use bica_motion::robot::{Buttons, CameraId, FootPressure, Inertial, Sensors};
use bica_motion::side::Side;
use bica_motion::walk::{Phase, Velocity, Walk};
use glam::{Vec2, Vec3};
use proptest::prelude::*;

use crate::motion::kinematics::any_angles;
use crate::motion::tall::TALL;
use crate::motion::world::{CYCLE, World, gap};

/// The ankle of the tall model, from its own lengths, with elementary rotations in f64.
fn reference_ankle(side: Side, angles: &Joints) -> [f64; 3] {
    let [yaw_pitch, hip_roll, hip_pitch, knee, ..] = side.leg().map(|joint| f64::from(angles[joint]));
    let sign = f64::from(side.sign());
    let about_y = |[x, y, z]: [f64; 3], a: f64| [a.cos() * x + a.sin() * z, y, -a.sin() * x + a.cos() * z];
    let about_x = |[x, y, z]: [f64; 3], a: f64| [x, a.cos() * y - a.sin() * z, a.sin() * y + a.cos() * z];
    let about_z = |[x, y, z]: [f64; 3], a: f64| [a.cos() * x - a.sin() * y, a.sin() * x + a.cos() * y, z];
    let tilt = sign * std::f64::consts::FRAC_PI_4;
    let [x, y, z] = about_y([0.0, 0.0, -0.14], knee);
    let p = about_x(about_y([x, y, z - 0.17], hip_pitch), hip_roll);
    let [x, y, z] = about_x(about_z(about_x(p, -tilt), -sign * yaw_pitch), tilt);
    [x, y + sign * 0.075, z]
}

proptest! {
    #![proptest_config(crate::motion::cases(1000))]

    #[test]
    fn forward_kinematics_use_the_lengths_of_the_model(angles in any_angles(TALL)) {
        for side in Side::BOTH {
            let found = kinematics::ankle(TALL, side, &angles).translation.to_array();
            let expected = reference_ankle(side, &angles);
            for (found, expected) in found.into_iter().zip(expected) {
                prop_assert!((f64::from(found) - expected).abs() < 1e-6, "{side:?}: {found} is not {expected}");
            }
        }
    }

    #[test]
    fn clamping_uses_the_limits_of_the_model(wild in prop::array::uniform25(-10.0_f32..10.0)) {
        let clamped = Joints(wild).clamp_to_limits(TALL);
        for (i, (&wild, clamped)) in wild.iter().zip(clamped.0).enumerate() {
            let range = TALL.limits.0[i];
            prop_assert_eq!(clamped.to_bits(), wild.clamp(range.min, range.max).to_bits());
        }
    }
}

#[test]
fn total_mass_and_currents_follow_from_tables() {
    assert!((TALL.total_mass() - 20.5).abs() < 1e-4, "{}", TALL.total_mass());
    // 0.08 Nm at 24 V / 600 rad/s = 0.04 Nm/A.
    assert!((TALL.continuous_current(Joint::LKneePitch) - 2.0).abs() < 1e-6);
}

#[test]
fn the_second_model_stands_as_its_gait_plans() {
    let planned = TALL.kinematic_profile.gait.stand(TALL).joints(TALL);
    for joint in Joint::ALL {
        assert!(
            (TALL.stand[joint] - planned[joint]).abs() < 1e-5,
            "{joint:?}: {} is not {}",
            TALL.stand[joint],
            planned[joint]
        );
    }
    assert!(is_within_limits(&TALL.stand));
    let world = World::standing(TALL, TALL.stand);
    assert!((world.robot.translation.z - 0.3225).abs() < 1e-5, "{}", world.robot.translation.z);
    assert!(world.margin() > 0.03, "the mass is {} m inside the soles", world.margin());
}

#[test]
fn each_humanoid_has_its_own_id_and_can_stand() {
    for model in HUMANOIDS {
        assert_eq!(humanoid(model.id).map(|found| found.name), Some(model.name));
        let outside = model.joints.iter().find(|joint| !model.limits[**joint].contains(model.stand[**joint]));
        assert_eq!(outside, None, "{}", model.name);
    }
}

fn is_within_limits(angles: &Joints) -> bool {
    TALL.joints.iter().all(|&joint| TALL.limits[joint].contains(angles[joint]))
}

#[test]
fn second_model_walks_within_its_limits() {
    let gait = &TALL.kinematic_profile.gait;
    for (forward, left, turn) in
        [(0.25, 0.0, 0.0), (-0.15, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, -0.1, 0.0), (0.0, 0.0, 0.8), (0.15, 0.05, -0.3)]
    {
        let request = Velocity::new(forward, left, turn);
        let (mut walk, mut world) = (Walk::new(TALL, gait), World::standing(TALL, TALL.stand));
        let mut odometry = Odometry::new(TALL, &TALL.kinematic_profile.odometry);
        let mut last = TALL.stand;
        let (mut start, mut begin) = (world.ground(), odometry.pose());
        for cycle in 0..1200 {
            let feedback = world.body();
            let feet = [&feedback.left_foot, &feedback.right_foot];
            odometry.step(&MotionInput { commanded: None, angles: &world.angles, feet, gyro_turn: None });
            if cycle == 200 {
                (start, begin) = (world.ground(), odometry.pose());
            }
            let targets = walk.step(request, &feedback, CYCLE).joints(TALL);
            assert!(is_within_limits(&targets), "{request:?}: {targets:?}");
            for joint in TALL.joints.iter().copied() {
                let speed = (targets[joint] - last[joint]).abs() / CYCLE;
                assert!(speed <= 1.25 * TALL.max_speeds[joint], "{request:?}: {joint:?} at {speed} rad/s");
            }
            last = targets;
            world.step(&targets);
            assert!(world.margin() > 0.005, "{request:?}: the mass is {} m inside the soles", world.margin());
            assert!(gap(TALL, [&world.sole(Side::Left), &world.sole(Side::Right)]) > 0.002, "the feet touch");
        }
        assert_eq!(walk.phase(), Phase::Walking);
        let moved = start.inverse() * world.ground();
        let believed = begin.inverse() * odometry.pose();
        if turn == 0.0 {
            let expected = 10.0 * Vec2::new(forward, left);
            assert!(moved.position.distance(expected) < 0.1 * expected.length(), "{request:?}: {moved:?}");
        }
        assert!(moved.position.distance(believed.position) < 0.15, "{request:?}: {moved:?}, not {believed:?}");
    }
}

#[test]
fn the_second_model_kicks_and_returns_to_its_stand() {
    for foot in Side::BOTH {
        let kick = Kick { foot, ..Kick::ALL[0] };
        let mut motion = KickMotion::new(TALL, kick, TALL.kinematic_profile);
        let mut world = World::standing(TALL, TALL.stand);
        let mut farthest = 0.0_f32;
        while !motion.is_done() {
            let targets = motion.step(&world.body(), CYCLE).joints(TALL);
            assert!(is_within_limits(&targets), "{targets:?}");
            world.step(&targets);
            assert!(world.margin() > 0.005, "the mass is {} m inside the soles", world.margin());
            farthest = farthest.max(world.sole(foot).translation.x);
        }
        assert!((0.15..0.2).contains(&farthest), "the foot swings to {farthest} m");
        for joint in TALL.joints.iter().copied() {
            assert!((world.angles[joint] - TALL.stand[joint]).abs() < 0.02, "{joint:?}");
        }
    }
}

#[test]
fn the_head_uses_the_limits_and_cameras_of_the_model() {
    let near = |found: f32, expected: f32| (found.to_degrees() - expected).abs() < 1e-3;
    assert!(near(pitch_range(TALL, 0.0).max, 40.0) && near(pitch_range(TALL, f32::to_radians(45.0)).max, 30.0));
    let clamped = HeadAngles { yaw: 3.0, pitch: 1.0 }.clamped(TALL);
    assert!(near(clamped.yaw, 90.0) && near(clamped.pitch, 20.0), "{clamped:?}");
    let point = Vec3::new(1.0, 0.0, -0.3);
    for camera in [CameraId::Top, CameraId::Bottom] {
        let mut angles = Joints::all(0.0);
        look_at(TALL, camera, point).write(&mut angles);
        let seen = Skeleton::of(TALL, &angles).camera(camera).inverse().transform_point3(point);
        assert!(seen.x > 0.0 && seen.y.abs() < 1e-5, "{seen}");
    }
}

#[test]
fn fall_limits_belong_to_the_model() {
    let inertial = Inertial { pitch: 0.5, acceleration: Vec3::new(0.0, 0.0, 9.81), ..Inertial::default() };
    let (mut nao, mut tall) = (FallDetector::new(NAO), FallDetector::new(TALL));
    for _ in 0..10 {
        nao.step(&inertial, CYCLE);
        tall.step(&inertial, CYCLE);
    }
    assert!(nao.state().is_upright());
    assert!(matches!(tall.state(), FallState::Falling(_)), "{:?}", tall.state());
}

/// The fault after 300 cycles in stand with a knee at this temperature, °C.
fn fault(model: &'static RobotModel, temperature: f32) -> Option<Fault> {
    let mut health = Health::new(model);
    let foot = FootPressure { front_left: 100.0, ..FootPressure::default() };
    let mut temperatures = Joints::all(40.0);
    temperatures[Joint::LKneePitch] = temperature;
    for cycle in 0..300_u16 {
        // The gyroscope neither repeats a value nor measures a turn.
        let gyro = Vec3::splat(if cycle % 2 == 0 { 0.01 } else { -0.01 });
        let inertial = Inertial { gyro, acceleration: Vec3::Z, ..Inertial::default() };
        let sensors = Sensors {
            angles: model.stand,
            temperatures,
            currents: Joints::all(0.1),
            inertial,
            left_foot: foot,
            right_foot: foot,
            buttons: Buttons::default(),
            image: None,
        };
        health.step(&sensors, &model.stand, &Joints::all(1.0));
    }
    health.fault()
}

#[test]
fn health_uses_the_thermal_limits_of_the_model() {
    assert_eq!(fault(NAO, 76.0), Some(Fault::Hot(Joint::LKneePitch)));
    assert_eq!(fault(TALL, 76.0), None);
    assert_eq!(fault(TALL, 91.0), Some(Fault::Hot(Joint::LKneePitch)));
}
