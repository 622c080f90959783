//! Tests of falling, lying and getting up.

use core::ops::RangeInclusive;

use bica_motion::fall::{Direction, FallDetector, FallState};
use bica_motion::getup::{GetUp, HOLD, TUCK_KNEE_ANGLE, protection};
use bica_motion::joints::{Joint, Joints};
use bica_motion::keyframes::{Keyframe, Motion};
use bica_motion::kinematics::{Skeleton, ground_from_robot};
use bica_motion::model::simulation::HUMANOIDS;
use bica_motion::model::{NAO, RobotModel};
use bica_motion::robot::Inertial;
use bica_motion::side::Side;
use bica_motion::stiffness::Stiffness;
use glam::{Quat, Vec3};

use crate::motion::world::{CYCLE, World};

/// Reading of the inertial unit of a torso with the rotation `tilt`.
fn tilted(tilt: Quat) -> Inertial {
    let up = tilt.inverse() * Vec3::Z;
    let (y, z, x) = (tilt * Vec3::Y, tilt * Vec3::Z, tilt * Vec3::X);
    Inertial { gyro: Vec3::ZERO, acceleration: 9.81 * up, roll: y.z.atan2(z.z), pitch: (-x.z).asin() }
}

fn toward(direction: Direction, angle: f32) -> Quat {
    match direction {
        Direction::Front => Quat::from_rotation_y(angle),
        Direction::Back => Quat::from_rotation_y(-angle),
        Direction::Left => Quat::from_rotation_x(-angle),
        Direction::Right => Quat::from_rotation_x(angle),
    }
}

#[test]
fn falls_in_every_direction_are_detected() {
    for direction in Direction::ALL {
        let mut detector = FallDetector::new(NAO);
        let mut seen = vec![detector.state()];
        let fall = (0..60).map(|i| 1.57 * (i as f32 / 60.0).powi(2));
        let rise = (0..50).map(|i| 1.57 * (1.0 - i as f32 / 50.0));
        let angles = fall.chain([1.57; 200]).chain(rise).chain([0.0; 60]);
        for angle in angles {
            let state = detector.step(&tilted(toward(direction, angle)), CYCLE);
            if seen.last() != Some(&state) {
                seen.push(state);
            }
        }
        let expected =
            [FallState::Upright, FallState::Falling(direction), FallState::Fallen(direction), FallState::Upright];
        assert_eq!(seen, expected);
    }
}

#[test]
fn tilts_and_jolts_of_a_walk_are_no_fall() {
    let mut detector = FallDetector::new(NAO);
    for i in 0..1000 {
        let (roll, pitch) = (0.2 * (0.2 * i as f32).sin(), 0.15 * (0.13 * i as f32).cos());
        let jolt = Vec3::new(0.0, 12.0 * (0.9 * i as f32).sin(), 5.0 * (1.3 * i as f32).cos());
        let mut inertial = tilted(Quat::from_rotation_x(roll) * Quat::from_rotation_y(pitch));
        inertial.acceleration += jolt;
        assert_eq!(detector.step(&inertial, CYCLE), FallState::Upright);
    }
}

#[test]
fn fall_without_acceleration_ends_after_its_maximum() {
    let mut detector = FallDetector::new(NAO);
    let strange = Inertial { pitch: 1.0, acceleration: Vec3::new(0.0, 0.0, 9.81), ..Inertial::default() };
    for _ in 0..130 {
        detector.step(&strange, CYCLE);
    }
    assert_eq!(detector.state(), FallState::Fallen(Direction::Front));
}

#[test]
fn the_lying_side_is_known_within_300_ms() {
    let mut detector = FallDetector::new(NAO);
    for direction in [Direction::Front, Direction::Left, Direction::Back] {
        for _ in 0..30 {
            detector.step(&tilted(toward(direction, 1.5)), CYCLE);
        }
        assert_eq!(detector.state(), FallState::Fallen(direction));
    }
}

#[test]
fn nan_readings_do_not_change_the_state() {
    let mut detector = FallDetector::new(NAO);
    let invalid = Inertial { pitch: f32::NAN, acceleration: Vec3::splat(f32::NAN), ..Inertial::default() };
    for _ in 0..100 {
        assert_eq!(detector.step(&invalid, CYCLE), FallState::Upright);
    }
    assert_eq!(detector.step(&tilted(toward(Direction::Back, 0.6)), CYCLE), FallState::Falling(Direction::Back));
}

/// Plays a motion from a posture; returns all targets.
fn play(frames: &'static [Keyframe], from: Joints) -> Vec<Joints> {
    let mut motion = Motion::new(frames, from);
    let mut targets = Vec::new();
    while !motion.is_done() {
        targets.push(motion.step(CYCLE).expect("there are frames").0);
    }
    targets
}

/// Plays a get-up with a constant inertial reading; returns all targets.
fn get_up(mut movement: GetUp, inertial: &Inertial) -> Vec<Joints> {
    let mut targets = Vec::new();
    while !movement.is_done() {
        targets.push(movement.step(inertial, CYCLE).0);
    }
    targets
}

#[test]
fn get_ups_keep_to_limits_and_end_in_the_stand() {
    for model in HUMANOIDS {
        check_get_ups(model.robot, if model.id == NAO.id { 4.0..=11.0 } else { 3.0..=5.5 });
    }
}

fn check_get_ups(model: &'static RobotModel, expected: RangeInclusive<f32>) {
    let crumpled = Joints::all(0.3).clamp_to_limits(model);
    let attempts =
        Direction::ALL.into_iter().flat_map(|direction| [0, 1, 3, 4, 255].map(|failures| (direction, failures)));
    for (direction, failures) in attempts {
        for start in [model.sit, crumpled, protection(model, direction).posture] {
            let targets = get_up(GetUp::new(model, direction, failures, start), &Inertial::default());
            let seconds = targets.len() as f32 * CYCLE;
            assert!(expected.contains(&seconds), "{}: {seconds} s", model.name);
            assert_eq!(*targets.last().unwrap(), model.stand);
            keeps_to_limits_and_speeds(model, &targets);
        }
    }
}

fn keeps_to_limits_and_speeds(model: &'static RobotModel, targets: &[Joints]) {
    for pair in targets.windows(2) {
        assert!(pair[1].within_limits(model), "{:?}", pair[1]);
        for joint in Joint::ALL {
            let speed = (pair[1][joint] - pair[0][joint]).abs() / CYCLE;
            assert!(speed <= model.max_speeds[joint] * 1.001, "{joint:?} at {speed} rad/s");
        }
    }
}

#[test]
fn every_third_attempt_turns_over() {
    let turn = |lying, failures| get_up(GetUp::new(NAO, lying, failures, NAO.stand), &tilted(toward(lying, 1.5)));
    for lying in [Direction::Front, Direction::Back] {
        let targets = turn(lying, 2);
        keeps_to_limits_and_speeds(NAO, &targets);
        assert!((0.5..2.5).contains(&(targets.len() as f32 * CYCLE)), "{} cycles", targets.len());
        let last = |failures| *turn(lying, failures).last().unwrap();
        let (one, other) = (last(2), last(5).mirrored());
        assert!(Joint::ALL.into_iter().all(|joint| (one[joint] - other[joint]).abs() < 1e-5));
        assert_eq!(turn(lying, 8), targets);
    }
    assert_ne!(turn(Direction::Front, 2), turn(Direction::Back, 2));
}

#[test]
fn a_get_up_passes_a_tuck_and_then_holds_the_stand() {
    for direction in Direction::ALL {
        let targets = get_up(GetUp::new(NAO, direction, 0, Joints::all(0.0)), &Inertial::default());
        let tucked = targets
            .iter()
            .position(|t| t[Joint::LKneePitch] > TUCK_KNEE_ANGLE && t[Joint::RKneePitch] > TUCK_KNEE_ANGLE);
        let tucked = tucked.expect("both knees pass the tuck angle");
        let held = targets[tucked..].iter().rev().take_while(|&&t| t == NAO.stand).count();
        assert!(held as f32 * CYCLE >= HOLD - 0.02, "{held} cycles");
    }
}

#[test]
fn every_second_attempt_is_the_mirror_image() {
    let way = |failures| get_up(GetUp::new(NAO, Direction::Back, failures, NAO.stand), &Inertial::default());
    assert_eq!(way(4), way(0));
    assert_eq!(way(3), way(1));
    let mirrored: Vec<Joints> = way(0).iter().map(Joints::mirrored).collect();
    for (own, expected) in way(1).iter().zip(&mirrored) {
        assert!(Joint::ALL.into_iter().all(|joint| (own[joint] - expected[joint]).abs() < 1e-5));
    }
}

#[test]
fn get_up_stops_when_the_robot_rolls_over() {
    let lying = |direction| tilted(toward(direction, 1.5));
    for (rolled_on, seconds) in [(Direction::Back, 2.0..4.0), (Direction::Front, 0.5..1.5)] {
        let targets = get_up(GetUp::new(NAO, Direction::Left, 0, NAO.stand), &lying(rolled_on));
        assert!(seconds.contains(&(targets.len() as f32 * CYCLE)), "{rolled_on:?}: {} cycles", targets.len());
    }
}

#[test]
fn get_up_stops_unless_the_robot_sits_before_the_rise() {
    let whole = get_up(GetUp::new(NAO, Direction::Front, 0, NAO.stand), &Inertial::default()).len();
    let sits = get_up(GetUp::new(NAO, Direction::Front, 0, NAO.stand), &tilted(toward(Direction::Front, 0.9))).len();
    let lies = get_up(GetUp::new(NAO, Direction::Front, 0, NAO.stand), &tilted(toward(Direction::Front, 1.2))).len();
    assert_eq!(sits, whole);
    assert!((whole - 450..whole - 350).contains(&lies), "{lies} of {whole} cycles");
}

#[test]
fn a_get_up_stops_if_a_risen_robot_falls_again() {
    let mut movement = GetUp::new(NAO, Direction::Front, 0, Joints::all(0.0));
    let lying = |direction| tilted(toward(direction, 1.5));
    for (inertial, cycles, over) in
        [(lying(Direction::Front), 100, false), (tilted(Quat::IDENTITY), 100, false), (lying(Direction::Back), 1, true)]
    {
        for _ in 0..cycles {
            movement.step(&inertial, CYCLE);
        }
        assert_eq!(movement.is_done(), over, "{inertial:?}");
    }
}

#[test]
fn mass_stays_over_the_feet_while_sitting_down() {
    let mut world = World::standing(NAO, NAO.stand);
    for frames in [NAO.to_sit, NAO.to_stand] {
        for targets in play(frames, world.angles) {
            world.step(&targets);
            assert!(world.margin() > 0.02, "{}", world.margin());
        }
        for _ in 0..5 {
            world.step(&frames[0].posture);
        }
        for joint in Joint::ALL {
            assert!((world.angles[joint] - frames[0].posture[joint]).abs() < 1e-6, "{joint:?}");
        }
    }
}

#[test]
fn the_stand_equals_that_of_the_quasi_static_gait() {
    let gait = NAO.kinematic_profile.gait.stand(NAO).joints(NAO);
    for joint in Joint::ALL {
        assert!((NAO.stand[joint] - gait[joint]).abs() < 1e-5, "{joint:?}: {} {}", NAO.stand[joint], gait[joint]);
    }
    let mass =
        ground_from_robot(NAO, Side::Left, &NAO.stand).transform_point3(Skeleton::of(NAO, &NAO.stand).centre_of_mass());
    assert!((mass.x - 0.02).abs() < 0.01 && mass.y.abs() < 0.001, "over the middle of the feet: {mass}");
}

#[test]
fn stiffness_grows_from_fall_to_walk() {
    for profile in [Stiffness::Limp, Stiffness::Stand, Stiffness::Walk, Stiffness::Fall] {
        assert!(profile.joints(NAO).0.iter().all(|value| (0.0..=1.0).contains(value)));
    }
    assert!(Stiffness::Limp.joints(NAO).0.iter().all(|&value| value == 0.0));
    let legs = |profile: Stiffness| profile.joints(NAO)[Joint::LKneePitch];
    assert!(legs(Stiffness::Fall) < legs(Stiffness::Stand) && legs(Stiffness::Stand) < legs(Stiffness::Walk));
}

#[test]
fn an_empty_motion_is_done_at_once() {
    assert!(GetUp::none(NAO).is_done());
    let mut none = Motion::none();
    assert!(none.is_done());
    assert_eq!(none.step(CYCLE), None);
}
