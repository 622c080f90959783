//! What the profile for real forces adds to walk and kicks. Whether it stands is tried in `MuJoCo`: `player trial`.

use std::collections::VecDeque;

use bica_motion::joints::{Joint, Joints};
use bica_motion::kick::{Kick, KickMotion};
use bica_motion::kinematics::{self, LegAngles};
use bica_motion::model::{Nao, RobotModel};
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Phase, Velocity, Walk};
use glam::Vec3;

use crate::world::CYCLE;

const NAO: &bica_motion::model::Profile = Nao::DYNAMIC_PROFILE;

fn force(newtons: f32) -> FootPressure {
    FootPressure { front_left: newtons, ..FootPressure::default() }
}

/// Stands on both feet alike.
fn level() -> Feedback {
    Feedback { left_foot: force(26.0), right_foot: force(26.0), ..Feedback::default() }
}

/// Walks for a while, feeling this when `side` carries.
fn walked(request: Velocity, cycles: usize, feedback: impl Fn(Side) -> Feedback) -> (Walk, Joints) {
    let mut walk = Walk::<Nao>::new(&NAO.gait);
    let mut targets = NAO.gait.stand::<Nao>().joints();
    for _ in 0..cycles {
        let body = walk.support().map_or_else(level, &feedback);
        targets = walk.step(request, &body, CYCLE).joints();
        assert!(targets.within_limits::<Nao>(), "{targets:?}");
    }
    (walk, targets)
}

/// How far the feet are apart, seen from the left one, m.
fn apart(targets: &Joints) -> Vec3 {
    let [left, right] = Side::BOTH.map(|side| kinematics::sole::<Nao>(side, targets));
    (left.inverse() * right).translation.into()
}

#[test]
fn no_joint_is_told_to_pass_its_limit() {
    for request in [
        Velocity::new(0.3, 0.0, 0.0),
        Velocity::new(-0.15, 0.0, 0.0),
        Velocity::new(0.0, 0.12, 0.0),
        Velocity::new(0.0, -0.12, 0.0),
        Velocity::new(0.0, 0.0, 0.8),
        Velocity::new(0.1, 0.05, 0.3),
    ] {
        let (walk, _) = walked(request, 500, |_| level());
        assert_eq!(walk.phase(), Phase::Walking);
    }
}

#[test]
fn a_body_that_topples_aside_is_caught_by_a_wider_step() {
    let widest = |rolled: f32| {
        let toppling = |side: Side| Feedback { roll: rolled * side.sign(), ..level() };
        let counts = 100..160;
        counts.map(|cycles| -apart(&walked(Velocity::new(0.1, 0.0, 0.0), cycles, toppling).1).y).fold(0.0, f32::max)
    };
    let (upright, toppling) = (widest(0.0), widest(0.2));
    assert!(toppling > upright + 0.01, "{toppling} m is not wider than {upright} m");
    assert!(toppling < upright + NAO.gait.max_capture_step.y + 0.01);
}

#[test]
fn a_step_that_catches_the_body_is_a_mode_of_its_own() {
    let phases = |rolled: f32| {
        let mut walk = Walk::<Nao>::new(&NAO.gait);
        let phases = (0..300).map(|_| {
            let roll = walk.support().map_or(0.0, |side| rolled * side.sign());
            walk.step(Velocity::new(0.1, 0.0, 0.0), &Feedback { roll, ..level() }, CYCLE);
            walk.phase()
        });
        phases.collect::<Vec<_>>()
    };
    assert!(!phases(0.0).contains(&Phase::Capturing));
    let toppling = phases(0.4);
    assert!(toppling.contains(&Phase::Capturing));
    let walks_again = |pair: &[Phase]| pair == [Phase::Capturing, Phase::Walking];
    assert!(toppling.windows(2).any(walks_again), "a step later it walks again");
}

#[test]
fn time_passes_slower_while_the_body_hangs_out_over_the_foot_that_carries() {
    let steps = |rolled: f32| {
        let mut walk = Walk::<Nao>::new(&NAO.gait);
        let (mut steps, mut before) = (0, None);
        for _ in 0..1000 {
            let roll = walk.support().map_or(0.0, |side| -rolled * side.sign());
            walk.step(Velocity::new(0.1, 0.0, 0.0), &Feedback { roll, ..level() }, CYCLE);
            steps += u32::from(walk.support() != before);
            before = walk.support();
        }
        steps
    };
    let (upright, hanging) = (steps(0.0), steps(0.15));
    assert!((35..=45).contains(&upright), "{upright} steps in 10 s");
    assert!(4 * hanging < 3 * upright, "{hanging} of {upright} steps");
}

#[test]
fn a_body_that_falls_forward_in_stand_presses_its_toes_down() {
    let mut walk = Walk::<Nao>::new(&NAO.gait);
    let stand = NAO.gait.stand::<Nao>();
    let mut limbs = stand;
    for _ in 0..5 {
        limbs = walk.step(Velocity::ZERO, &Feedback { gyro: Vec3::new(0.0, 0.5, 0.0), ..level() }, CYCLE);
    }
    for side in Side::BOTH {
        assert!(limbs.legs[side.index()].ankle_pitch > stand.legs[side.index()].ankle_pitch + 0.01);
    }
}

#[test]
fn wild_readings_move_no_joint_beyond_reason() {
    for wild in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30] {
        let feedback = Feedback { gyro: Vec3::splat(wild), roll: wild, pitch: wild, knees: Some([wild; 2]), ..level() };
        let mut walk = Walk::<Nao>::new(&NAO.gait);
        for _ in 0..500 {
            let targets = walk.step(Velocity::new(0.2, 0.0, 0.0), &feedback, CYCLE).joints();
            assert!(targets.0.iter().all(|angle| angle.is_finite()), "{targets:?}");
        }
    }
}

#[test]
fn kicks_keep_to_the_limits_and_come_back_to_the_stand() {
    for kick in Kick::ALL {
        let mut motion = KickMotion::<Nao>::new(kick, NAO);
        assert!(motion.seconds() < 2.5, "{kick:?}: {} s", motion.seconds());
        let mut targets = NAO.gait.stand::<Nao>().joints();
        for _ in 0..300 {
            targets = motion.step(&level(), CYCLE).joints();
            let clamped = targets.clamp_to_limits::<Nao>();
            let beyond = targets.0.iter().zip(clamped.0).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(beyond < 0.05, "{kick:?}: {beyond} rad beyond a limit");
        }
        assert!(motion.is_done());
        assert_eq!(targets, NAO.gait.stand::<Nao>().joints());
    }
}

/// The targets in the middle of a step of the left leg's, of a robot whose knees bend `sag` rad farther than they are told
/// when they carry.
fn carried(sag: f32) -> [LegAngles; 2] {
    let mut walk = Walk::<Nao>::new(&NAO.gait);
    let mut told = VecDeque::from(vec![NAO.gait.stand::<Nao>().joints(); 4]);
    let mut carried = [LegAngles::default(); 2];
    for cycle in 0..1000 {
        let carrying = walk.support();
        let knees = [Joint::LKneePitch, Joint::RKneePitch].map(|knee| told[0][knee] + sag);
        let body = carrying.map_or_else(level, |side| Feedback { knees: Some(knees), ..alone(side) });
        let limbs = walk.step(Velocity::new(0.1, 0.0, 0.0), &body, CYCLE);
        if carrying != walk.support() && cycle > 800 {
            // The step that has just begun is the other leg's: what the last cycle told was this one's.
            if let Some(side) = carrying {
                carried[side.index()] = LegAngles::read(side, &told[3]);
            }
        }
        told.pop_front();
        told.push_back(limbs.joints());
    }
    carried
}

/// Stands on one foot.
fn alone(side: Side) -> Feedback {
    let [left_foot, right_foot] = Side::BOTH.map(|foot| force(if foot == side { 52.0 } else { 0.0 }));
    Feedback { left_foot, right_foot, ..Feedback::default() }
}

#[test]
fn a_weak_leg_is_told_to_lift_and_stretch_more() {
    let [strong, usual, weak] =
        [0.0, NAO.gait.expected_knee_sag - 0.005, NAO.gait.expected_knee_sag + 0.05].map(carried);
    assert_eq!(strong, usual, "what the gait expects needs nothing");
    for side in Side::BOTH {
        let (strong, weak) = (strong[side.index()], weak[side.index()]);
        let lifted = side.sign() * (weak.hip_roll - strong.hip_roll);
        assert!((lifted - 0.05 * NAO.gait.sag_hip_gain).abs() < 0.005, "{side:?}: {lifted} rad");
        let stretched = strong.knee_pitch - weak.knee_pitch;
        assert!((stretched - 0.05 * NAO.gait.sag_knee_gain).abs() < 0.002, "{side:?}: {stretched} rad");
    }
}

#[test]
fn a_knee_that_measures_nonsense_is_not_a_weak_one() {
    let strong = carried(0.0);
    for wrong in [f32::NAN, f32::INFINITY, 1.0, -1.0] {
        assert_eq!(carried(wrong), strong, "{wrong}");
    }
}
