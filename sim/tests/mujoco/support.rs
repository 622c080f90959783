//! Worlds and commands for the tests.

use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_sim::World;
use bica_sim::mujoco::{MujocoWorld, Physics};
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

/// Returns the default physics without cameras.
pub(crate) fn blind() -> Physics {
    Physics { cameras: false, ..Physics::of(NAO) }
}

/// Returns a world with the robot alone at the centre mark and the ball aside.
pub(crate) fn alone(seed: u64, physics: &Physics) -> MujocoWorld {
    let start = Some(Start { robot: Pose2::ORIGIN, ball: Vec2::new(1.0, 1.5) });
    world(&Setup { seed, goalkeeper: false, start, ..Setup::default() }, physics)
}

pub(crate) fn world(setup: &Setup, physics: &Physics) -> MujocoWorld {
    MujocoWorld::new(NAO, setup, physics).unwrap()
}

/// Commands the standing posture for some cycles.
pub(crate) fn stand(world: &mut MujocoWorld, cycles: u32) {
    for _ in 0..cycles {
        world.act(&Command::new(NAO.stand, 1.0));
    }
}
