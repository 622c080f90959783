//! In-walk kicks.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_motion::side::Side;
use bica_motion::walk::{Parameters, Phase, Velocity, Walk, in_walk_kick_foot};
use glam::Vec2;

use crate::motion::world::{CYCLE, World};

const GAIT: &Parameters = &NAO.kinematic_profile.gait;

/// Walks forward with a kick request after 1.5 s. Returns the maximum forward position of each sole relative to the
/// hips, m, before and after the request, and the number of kick steps.
fn walk_and_kick(speed: f32, foot: Side) -> ([[f32; 2]; 2], u32) {
    let (mut walk, mut world) = (Walk::new(NAO, GAIT), World::standing(NAO, GAIT.stand(NAO).joints(NAO)));
    let (mut farthest, mut kicks, mut before) = ([[0.0_f32; 2]; 2], 0, GAIT.stand(NAO).joints(NAO));
    for cycle in 0..400 {
        if cycle == 150 {
            walk.request_kick(foot);
        }
        let was = walk.phase();
        let targets = walk.step(Velocity::new(speed, 0.0, 0.0), &world.body(), CYCLE).joints(NAO);
        kicks += u32::from(walk.phase() == Phase::Kicking && was != Phase::Kicking);
        world.step(&targets);
        assert!(world.margin() >= 0.005, "{speed} m/s: the mass is {} m inside", world.margin());
        check_speeds(&before, &targets);
        before = targets;
        let hips = world.pose();
        for side in Side::BOTH {
            let ahead = hips.locate(world.sole(side).translation.truncate()).x;
            let most = &mut farthest[usize::from(cycle >= 150)][side.index()];
            *most = most.max(ahead);
        }
    }
    (farthest, kicks)
}

fn check_speeds(before: &Joints, after: &Joints) {
    for joint in Joint::ALL.into_iter().filter(|joint| (7..18).contains(&joint.index())) {
        let speed = (after[joint] - before[joint]).abs() / CYCLE;
        assert!(speed <= 1.25 * NAO.max_speeds[joint], "{joint:?} at {speed} rad/s");
    }
}

#[test]
fn in_walk_kick_extends_one_swing() {
    for speed in [0.08, 0.15, 0.2] {
        for foot in Side::BOTH {
            let ([before, after], kicks) = walk_and_kick(speed, foot);
            assert_eq!(kicks, 1);
            let (own, other) = (foot.index(), foot.other().index());
            assert!(after[own] > before[own] + 0.015, "{speed} m/s: {before:?} {after:?}");
            assert!((after[other] - before[other]).abs() < 0.005, "{speed} m/s: {before:?} {after:?}");
        }
    }
}

#[test]
fn a_kick_request_in_stand_changes_no_target() {
    let (mut walk, mut world) = (Walk::new(NAO, GAIT), World::standing(NAO, GAIT.stand(NAO).joints(NAO)));
    walk.request_kick(Side::Left);
    for _ in 0..100 {
        let targets = walk.step(Velocity::ZERO, &world.body(), CYCLE);
        assert_eq!((walk.phase(), targets), (Phase::Standing, GAIT.stand(NAO)));
        world.step(&targets.joints(NAO));
    }
}

#[test]
fn in_walk_kick_reaches_a_ball_before_a_foot() {
    assert_eq!(in_walk_kick_foot(Vec2::new(0.18, 0.055), GAIT), Some(Side::Left));
    assert_eq!(in_walk_kick_foot(Vec2::new(0.18, -0.045), GAIT), Some(Side::Right));
    for out in [(0.18, 0.0), (0.18, 0.09), (0.05, 0.05), (0.3, -0.05), (f32::NAN, 0.05), (0.18, f32::NAN)] {
        assert_eq!(in_walk_kick_foot(out.into(), GAIT), None, "{out:?}");
    }
}
