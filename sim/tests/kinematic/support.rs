//! A scripted robot: foot positions instead of a gait.

use bica_motion::feet::{Foot, level_legs};
use bica_motion::joints::Joints;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

/// Height of the hips above the ground, m.
pub(crate) const HIPS: f32 = 0.215;
/// Lateral offset of the hips over the support foot, m.
pub(crate) const SWAY: f32 = 0.045;

/// Returns a world without other robots in which the robot stands at a pose.
pub(crate) fn alone(seed: u64, robot: Pose2, ball: Vec2) -> KinematicWorld {
    let start = Some(Start { robot, ball });
    KinematicWorld::new(NAO, &Setup { seed, goalkeeper: false, start, ..Setup::default() }).expect("a valid setup")
}

/// Returns the posture with an upright torso and these feet, left first: x, y relative to the hips, and lift, m.
pub(crate) fn posture(feet: [(f32, f32, f32); 2]) -> Joints {
    let feet = feet.map(|(x, y, lift)| Foot { pose: Pose2::new(x, y, 0.0), lift });
    let mut posture = NAO.stand;
    for (side, leg) in Side::BOTH.into_iter().zip(level_legs(NAO, &feet, HIPS, 0.0)) {
        leg.write(NAO, side, &mut posture);
    }
    posture
}

/// Moves both feet linearly between two positions in a number of cycles.
pub(crate) fn glide(world: &mut KinematicWorld, from: [(f32, f32, f32); 2], to: [(f32, f32, f32); 2], cycles: u32) {
    for cycle in 1..=cycles {
        let part = cycle as f32 / cycles as f32;
        let mix = |a: f32, b: f32| a + part * (b - a);
        let feet = [0, 1].map(|i| (mix(from[i].0, to[i].0), mix(from[i].1, to[i].1), mix(from[i].2, to[i].2)));
        world.act(&Command::new(posture(feet), 1.0));
    }
}

/// Feet side by side, the hips between them.
pub(crate) const TOGETHER: [(f32, f32, f32); 2] = [(-0.012, 0.05, 0.0), (-0.012, -0.05, 0.0)];

/// Returns feet side by side with the hips above one of them.
pub(crate) fn swayed(side: Side) -> [(f32, f32, f32); 2] {
    TOGETHER.map(|(x, y, lift)| (x, y - side.sign() * SWAY, lift))
}
