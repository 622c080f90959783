//! Odometry compared with the true motion in the quasi-static world.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_motion::odometry::{Calibration, MotionInput, Odometry};
use bica_motion::pose::{Pose2, wrap};
use bica_motion::robot::FootPressure;
use bica_motion::walk::{Velocity, Walk};
use proptest::prelude::*;

use crate::motion::world::{CYCLE, World};

proptest! {
    #![proptest_config(crate::motion::cases(50))]

    #[test]
    fn the_drift_is_below_three_percent_of_the_path(
        requests in prop::collection::vec(prop::array::uniform3(-1.0_f32..1.0), 1..6),
        with_commands: bool,
    ) {
        let mut walk = Walk::new(NAO, &NAO.kinematic_profile.gait);
        let mut world = World::standing(NAO, NAO.kinematic_profile.gait.stand(NAO).joints(NAO));
        let mut odometry = Odometry::new(NAO, &Calibration::EXACT);
        let start = world.ground();
        let (mut way, mut commanded) = (0.0, None);
        for request in requests {
            for _ in 0..150 {
                let body = world.body();
                let input = measured(&world.angles, [&body.left_foot, &body.right_foot]);
                odometry.step(&MotionInput { commanded: commanded.as_ref(), ..input });
                let request = Velocity::new(0.25 * request[0], 0.12 * request[1], 1.2 * request[2]);
                let before = world.ground();
                let targets = walk.step(request, &body, CYCLE).joints(NAO);
                commanded = with_commands.then_some(targets);
                world.step(&targets);
                way += (start.inverse() * world.ground()).position.distance((start.inverse() * before).position);
            }
        }
        let body = world.body();
        odometry.step(&measured(&world.angles, [&body.left_foot, &body.right_foot]));
        let (true_pose, found) = (start.inverse() * world.ground(), odometry.pose());
        let off = true_pose.position.distance(found.position);
        prop_assert!(off < 0.02 + 0.03 * way, "{off} m off after {way} m");
        let gyro_turn = wrap(true_pose.heading - found.heading);
        prop_assert!(gyro_turn.abs() < 0.15, "{gyro_turn} rad off");
    }
}

/// Input with measured angles and foot forces only.
fn measured<'a>(angles: &'a Joints, feet: [&'a FootPressure; 2]) -> MotionInput<'a> {
    MotionInput { commanded: None, angles, feet, gyro_turn: None }
}

fn ground(force: f32) -> FootPressure {
    FootPressure { front_left: force, ..FootPressure::default() }
}

#[test]
fn lifted_feet_and_invalid_inputs_give_no_motion() {
    let mut odometry = Odometry::new(NAO, &Calibration::EXACT);
    let mut angles = NAO.stand;
    for i in 0..10 {
        angles.0[9] += 0.05;
        let motion = odometry.step(&measured(&angles, [&ground(0.0); 2]));
        assert_eq!(motion, Pose2::ORIGIN, "{i}");
        assert_eq!(odometry.support(), None);
    }
    let feet = [&ground(30.0), &ground(20.0)];
    odometry.step(&measured(&Joints::all(f32::NAN), feet));
    let nowhere = [&ground(30.0), &ground(f32::NAN)];
    odometry.step(&MotionInput { gyro_turn: Some(f32::NAN), ..measured(&NAO.stand, nowhere) });
    odometry.step(&MotionInput { gyro_turn: Some(f32::INFINITY), ..measured(&NAO.stand, feet) });
    odometry.step(&MotionInput { commanded: Some(&Joints::all(f32::NAN)), ..measured(&NAO.stand, feet) });
    assert_eq!(odometry.pose(), Pose2::ORIGIN);
    odometry.step(&MotionInput { gyro_turn: Some(0.05), ..measured(&NAO.stand, feet) });
    assert_eq!(odometry.pose(), Pose2::new(0.0, 0.0, 0.05), "the turn is that of the gyroscope");
}

/// Posture in one cycle of a motion: the hips move forward over the left foot, and the right foot is lifted.
fn leaning(cycle: usize) -> Joints {
    let mut angles = NAO.stand;
    angles[Joint::RKneePitch] += 0.3;
    for joint in [Joint::LAnklePitch, Joint::RAnklePitch] {
        angles[joint] -= 0.01 * cycle as f32;
    }
    // The right foot moves with the hips, so that the ground between the feet moves, too.
    angles[Joint::RHipPitch] -= 0.01 * cycle as f32;
    angles
}

/// Forward displacement of the ground frame, m, in 20 cycles of motion after 20 cycles at rest.
fn way(commanded: impl Fn(usize) -> Option<Joints>, is: impl Fn(usize) -> Joints, feet: [f32; 2]) -> f32 {
    let mut odometry = Odometry::new(NAO, &Calibration::EXACT);
    let feet = feet.map(ground);
    for cycle in 0..50 {
        let moving = |late: usize| cycle.clamp(20 + late, 40 + late) - 20 - late;
        let (commanded, angles) = (commanded(moving(0)), is(moving(3)));
        odometry.step(&MotionInput { commanded: commanded.as_ref(), ..measured(&angles, feet.each_ref()) });
    }
    odometry.pose().position.x
}

#[test]
fn measured_angles_gain_weight_with_foot_forces() {
    let (commanded, no_command, still) = (|cycle| Some(leaning(cycle)), |_| None, |_| Some(leaning(0)));
    let left = [50.0, 2.0];
    let full = way(commanded, leaning, left);
    assert!(full > 0.01, "{full} m");
    let near = |way: f32, share: f32| (way - share * full).abs() < 0.02 * full;
    let legs_alone = way(no_command, leaning, left);
    assert!(near(legs_alone, 1.0), "measured angles only: {legs_alone} of {full} m");
    let firmly = way(still, leaning, left);
    assert!(near(firmly, 1.0), "all weight on one foot: {firmly} of {full} m");
    let between = way(still, leaning, [26.1, 25.9]);
    assert!(near(between, 0.0), "equal weight on both feet: {between} of {full} m");
    let half = way(still, leaning, [32.5, 19.5]);
    assert!(near(half, 0.5), "a quarter of the weight apart: {half} of {full} m");
}

#[test]
fn commanded_angles_replace_bad_measurements() {
    let commanded = |cycle| Some(leaning(cycle));
    let left = [50.0, 2.0];
    let full = way(commanded, leaning, left);
    for (name, way) in [
        ("no number", way(commanded, |_| Joints::all(f32::NAN), left)),
        ("the same again and again", way(commanded, |_| leaning(0), left)),
        ("wild", way(commanded, |cycle| leaning(100 * (cycle % 2)), left)),
    ] {
        assert!((way - full).abs() < 0.1 * full, "{name}: {way} of {full} m");
    }
    let silent = way(commanded, leaning, [0.0, 0.0]);
    assert!((silent - full).abs() < 1e-4, "silent feet: {silent} of {full} m");
}

#[test]
fn zero_gyroscope_turn_is_replaced_by_the_legs() {
    let gyro_turn = |gyroscope: Option<f32>| {
        let mut odometry = Odometry::new(NAO, &Calibration::EXACT);
        let feet = [&ground(50.0), &ground(2.0)];
        for cycle in 0..20 {
            let mut angles = NAO.stand;
            angles[Joint::LHipYawPitch] = -0.01 * cycle as f32;
            odometry.step(&MotionInput { gyro_turn: gyroscope, ..measured(&angles, feet) });
        }
        odometry.pose().heading
    };
    let legs = gyro_turn(None);
    assert!(legs.abs() > 0.02, "{legs} rad");
    assert_eq!(gyro_turn(Some(0.0)).to_bits(), legs.to_bits());
    assert!((gyro_turn(Some(0.002)) - 0.04).abs() < 1e-4);
}
