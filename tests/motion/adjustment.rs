//! Tests of gait adjustments.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics;
use bica_motion::model::NAO;
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use bica_motion::walk::{Adjustment, Feedback, Parameters, Velocity, Walk};
use glam::Vec3;

use crate::motion::world::CYCLE;

const GAIT: &Parameters = &NAO.dynamic_profile.gait;
const FORWARD: Velocity = Velocity::new(9.0, 0.0, 0.0);

/// Feedback with the same weight on both feet and a pitch rate of the torso, rad/s.
fn feedback(pitch_rate: f32) -> Feedback {
    let foot = FootPressure { front_left: 26.0, ..FootPressure::default() };
    Feedback { gyro: Vec3::new(0.0, pitch_rate, 0.0), left_foot: foot, right_foot: foot, ..Feedback::default() }
}

/// Returns the walk after 300 cycles, and the targets of all cycles.
fn walked(adjustment: Adjustment, request: Velocity, pitch_rate: f32) -> (Walk, Vec<Joints>) {
    let mut walk = Walk::new(NAO, GAIT);
    walk.set_adjustment(adjustment);
    let targets = (0..300).map(|_| walk.step(request, &feedback(pitch_rate), CYCLE).joints(NAO)).collect();
    (walk, targets)
}

/// Largest height difference of the two soles, m.
fn swing_height(targets: &[Joints]) -> f32 {
    let height = |targets: &Joints| {
        let [left, right] = Side::BOTH.map(|side| kinematics::sole(NAO, side, targets).translation.z);
        (left - right).abs()
    };
    targets.iter().map(height).fold(0.0, f32::max)
}

#[test]
fn speed_limit_scales_both_directions() {
    for speed_limit in [0.5, 1.0, 1.2] {
        let (walk, _) = walked(Adjustment { speed_limit, ..Adjustment::NONE }, FORWARD, 0.0);
        // Planned velocity at the limit, with which the body moves.
        let limit = GAIT.max_velocity.forward * speed_limit;
        let expected = GAIT.velocity_scale.forward * (limit - GAIT.velocity_drift.forward);
        assert!((walk.velocity().forward - expected).abs() < 1e-3, "{speed_limit}: {:?}", walk.velocity());
    }
}

#[test]
fn a_request_below_the_limit_is_not_scaled() {
    let request = Velocity::new(0.1, 0.0, 0.0);
    let (walk, _) = walked(Adjustment { speed_limit: 0.5, ..Adjustment::NONE }, request, 0.0);
    let (expected, _) = walked(Adjustment::NONE, request, 0.0);
    assert!((walk.velocity().forward - expected.velocity().forward).abs() < 1e-5, "{:?}", walk.velocity());
}

#[test]
fn step_height_scales_the_swing_foot() {
    let height = |step_height| swing_height(&walked(Adjustment { step_height, ..Adjustment::NONE }, FORWARD, 0.0).1);
    for scale in [0.5, 2.0] {
        let ratio = height(scale) / height(1.0);
        assert!((ratio - scale).abs() < 0.1, "{scale}: {ratio}");
    }
}

#[test]
fn the_lean_turns_both_hips_and_no_other_joint() {
    for request in [Velocity::ZERO, FORWARD] {
        let lean = 0.05;
        // The capture-point error is the same, because the torso is tilted by its lean.
        let mut tilted = feedback(0.0);
        tilted.pitch = lean;
        let (mut plain, mut leaning) = (Walk::new(NAO, GAIT), Walk::new(NAO, GAIT));
        leaning.set_adjustment(Adjustment { torso_lean: lean, ..Adjustment::NONE });
        for cycle in 0..300 {
            let from = plain.step(request, &feedback(0.0), CYCLE).joints(NAO);
            let to = leaning.step(request, &tilted, CYCLE).joints(NAO);
            for joint in Joint::ALL {
                let expected = if matches!(joint, Joint::LHipPitch | Joint::RHipPitch) { -lean } else { 0.0 };
                let found = to[joint] - from[joint];
                assert!((found - expected).abs() < 1e-4, "cycle {cycle}, {joint:?}: {found}");
            }
        }
    }
}

#[test]
fn the_balance_scales_the_correction_of_the_ankles() {
    let ankle = |balance, rate| {
        let (_, targets) = walked(Adjustment { balance, ..Adjustment::NONE }, Velocity::ZERO, rate);
        targets[299][Joint::LAnklePitch]
    };
    let correction = |balance| ankle(balance, 0.5) - ankle(balance, 0.0);
    assert!(correction(1.0).abs() > 1e-3, "{}", correction(1.0));
    assert_eq!(correction(0.0).to_bits(), 0.0_f32.to_bits());
    assert!((correction(2.0) / correction(1.0) - 2.0).abs() < 0.01, "{} {}", correction(2.0), correction(1.0));
}
