//! The dynamic profile of walk and kicks. Its stability is tested in `MuJoCo`: `player trial`.

use std::collections::VecDeque;

use bica_motion::joints::{Joint, Joints};
use bica_motion::kick::{Kick, KickMotion};
use bica_motion::kinematics::{self, LegAngles};
use bica_motion::model::{NAO, T1};
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Phase, Velocity, Walk};
use glam::Vec3;

use crate::motion::world::CYCLE;

const PROFILE: &bica_motion::model::Profile = NAO.dynamic_profile;

fn force(newtons: f32) -> FootPressure {
    FootPressure { front_left: newtons, ..FootPressure::default() }
}

/// Feedback with equal force on both feet.
fn level() -> Feedback {
    Feedback { left_foot: force(26.0), right_foot: force(26.0), ..Feedback::default() }
}

/// Walks for some cycles with the given feedback for each support side.
fn walked(request: Velocity, cycles: usize, feedback: impl Fn(Side) -> Feedback) -> (Walk, Joints) {
    let mut walk = Walk::new(NAO, &PROFILE.gait);
    let mut targets = PROFILE.gait.stand(NAO).joints(NAO);
    for _ in 0..cycles {
        let body = walk.support().map_or_else(level, &feedback);
        targets = walk.step(request, &body, CYCLE).joints(NAO);
        assert!(targets.within_limits(NAO), "{targets:?}");
    }
    (walk, targets)
}

/// Position of the right sole in the frame of the left one, m.
fn apart(targets: &Joints) -> Vec3 {
    let [left, right] = Side::BOTH.map(|side| kinematics::sole(NAO, side, targets));
    (left.inverse() * right).translation.into()
}

#[test]
fn targets_of_the_dynamic_gait_are_within_the_limits() {
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
fn lateral_tilt_widens_the_step_to_its_maximum() {
    let widest = |rolled: f32| {
        let toppling = |side: Side| Feedback { roll: rolled * side.sign(), ..level() };
        let counts = 100..160;
        counts.map(|cycles| -apart(&walked(Velocity::new(0.1, 0.0, 0.0), cycles, toppling).1).y).fold(0.0, f32::max)
    };
    let (upright, toppling) = (widest(0.0), widest(0.2));
    assert!(toppling > upright + 0.01, "{toppling} m is not wider than {upright} m");
    assert!(toppling < upright + PROFILE.gait.max_capture_step.y + 0.01);
}

#[test]
fn a_large_capture_step_is_a_phase_of_its_own() {
    let phases = |rolled: f32| {
        let mut walk = Walk::new(NAO, &PROFILE.gait);
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
    assert!(toppling.windows(2).any(walks_again), "the phase returns to walking");
}

#[test]
fn outward_tilt_slows_the_gait_phase() {
    let steps = |rolled: f32| {
        let mut walk = Walk::new(NAO, &PROFILE.gait);
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
    assert!(5 * hanging < 4 * upright, "{hanging} of {upright} steps");
}

#[test]
fn forward_pitch_rate_in_stand_presses_the_toes_down() {
    let mut walk = Walk::new(NAO, &PROFILE.gait);
    let stand = PROFILE.gait.stand(NAO);
    let mut limbs = stand;
    for _ in 0..5 {
        limbs = walk.step(Velocity::ZERO, &Feedback { gyro: Vec3::new(0.0, 0.5, 0.0), ..level() }, CYCLE);
    }
    for side in Side::BOTH {
        assert!(limbs.legs[side.index()].ankle_pitch > stand.legs[side.index()].ankle_pitch + 0.01);
    }
}

#[test]
fn targets_stay_finite_for_any_feedback() {
    for wild in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30] {
        let feedback =
            Feedback { gyro: Vec3::splat(wild), roll: wild, pitch: wild, joints: Some(Joints::all(wild)), ..level() };
        let mut walk = Walk::new(NAO, &PROFILE.gait);
        for _ in 0..500 {
            let targets = walk.step(Velocity::new(0.2, 0.0, 0.0), &feedback, CYCLE).joints(NAO);
            assert!(targets.0.iter().all(|angle| angle.is_finite()), "{targets:?}");
        }
    }
}

#[test]
fn dynamic_kicks_keep_limits_and_return() {
    for kick in Kick::ALL {
        let mut motion = KickMotion::new(NAO, kick, PROFILE);
        assert!(motion.seconds() < 2.5, "{kick:?}: {} s", motion.seconds());
        let mut targets = PROFILE.gait.stand(NAO).joints(NAO);
        for _ in 0..300 {
            targets = motion.step(&level(), CYCLE).joints(NAO);
            let clamped = targets.clamp_to_limits(NAO);
            let beyond = targets.0.iter().zip(clamped.0).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(beyond < 0.05, "{kick:?}: {beyond} rad beyond a limit");
        }
        assert!(motion.is_done());
        assert_eq!(targets, PROFILE.gait.stand(NAO).joints(NAO));
    }
}

/// Targets of both legs at the end of their support, if the knee of the support leg sags by `sag` rad.
fn at_support_end(sag: f32) -> [LegAngles; 2] {
    let mut walk = Walk::new(NAO, &PROFILE.gait);
    let mut commanded = VecDeque::from(vec![PROFILE.gait.stand(NAO).joints(NAO); 4]);
    let mut carried = [LegAngles::default(); 2];
    for cycle in 0..1000 {
        let support = walk.support();
        let mut joints = commanded[0];
        for knee in [Joint::LKneePitch, Joint::RKneePitch] {
            joints[knee] += sag;
        }
        let body = support.map_or_else(level, |side| Feedback { joints: Some(joints), ..alone(side) });
        let limbs = walk.step(Velocity::new(0.1, 0.0, 0.0), &body, CYCLE);
        if support != walk.support() && cycle > 800 {
            // The next step has just begun: the last recorded command belongs to the support of `side`.
            if let Some(side) = support {
                carried[side.index()] = LegAngles::read(NAO, side, &commanded[3]);
            }
        }
        commanded.pop_front();
        commanded.push_back(limbs.joints(NAO));
    }
    carried
}

/// Feedback with all force on one foot.
fn alone(side: Side) -> Feedback {
    let [left_foot, right_foot] = Side::BOTH.map(|foot| force(if foot == side { 52.0 } else { 0.0 }));
    Feedback { left_foot, right_foot, ..Feedback::default() }
}

#[test]
fn knee_sag_adds_hip_roll_and_knee_extension() {
    let [strong, usual, weak] =
        [0.0, PROFILE.gait.expected_knee_sag - 0.005, PROFILE.gait.expected_knee_sag + 0.05].map(at_support_end);
    assert_eq!(strong, usual, "an expected sag is not compensated");
    for side in Side::BOTH {
        let (strong, weak) = (strong[side.index()], weak[side.index()]);
        let lifted = side.sign() * (weak.hip_roll - strong.hip_roll);
        assert!((lifted - 0.05 * PROFILE.gait.sag_hip_gain).abs() < 0.005, "{side:?}: {lifted} rad");
        let stretched = strong.knee_pitch - weak.knee_pitch;
        assert!((stretched - 0.05 * PROFILE.gait.sag_knee_gain).abs() < 0.002, "{side:?}: {stretched} rad");
    }
}

#[test]
fn implausible_knee_angles_are_not_compensated() {
    let strong = at_support_end(0.0);
    for wrong in [f32::NAN, f32::INFINITY, 1.0, -1.0] {
        assert_eq!(at_support_end(wrong), strong, "{wrong}");
    }
}

#[test]
fn compliant_robot_steps_after_its_centre_of_mass() {
    // The hips move over the soles at `rate` rad/s while the torso stays level and still.
    let farthest_step = |rate: f32| {
        let gait = &T1.dynamic_profile.gait;
        let mut walk = Walk::new(T1, gait);
        let (mut joints, mut moved, mut farthest) = (gait.stand(T1).joints(T1), 0.0, 0.0_f32);
        for cycle in 0..200 {
            moved += if cycle >= 150 { rate * CYCLE } else { 0.0 };
            for hip in [Joint::LHipPitch, Joint::RHipPitch] {
                joints[hip] += moved;
            }
            let foot = force(150.0);
            let body = Feedback { joints: Some(joints), left_foot: foot, right_foot: foot, ..Feedback::default() };
            joints = walk.step(Velocity::new(0.2, 0.0, 0.0), &body, CYCLE).joints(T1);
            let ahead = Side::BOTH.map(|side| kinematics::sole(T1, side, &joints).translation.x);
            farthest = ahead.into_iter().fold(farthest, f32::max);
        }
        farthest
    };
    assert!(farthest_step(1.0) > farthest_step(0.0) + 0.05);
}
