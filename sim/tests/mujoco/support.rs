//! Worlds and commands for the tests.

use bica_motion::joints::Joints;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command, Lights};
use bica_sim::World;
use bica_sim::mujoco::{MujocoWorld, Physics};
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

/// Returns the default physics without cameras.
pub(crate) fn blind() -> Physics {
    Physics { cameras: false, ..Physics::of::<Nao>() }
}

/// Returns a world with the robot alone at the centre mark and the ball aside.
pub(crate) fn alone(seed: u64, physics: &Physics) -> MujocoWorld<Nao> {
    let start = Some(Start { robot: Pose2::ORIGIN, ball: Vec2::new(1.0, 1.5) });
    world(&Setup { seed, goalkeeper: false, start, ..Setup::default() }, physics)
}

pub(crate) fn world(setup: &Setup, physics: &Physics) -> MujocoWorld<Nao> {
    MujocoWorld::<Nao>::new(setup, physics).unwrap()
}

pub(crate) fn command(targets: Joints, stiffness: f32) -> Command {
    let camera = CameraId::Top;
    Command { targets, stiffness: Joints::all(stiffness), lights: Lights::default(), camera }
}

/// Commands the standing posture for some cycles.
pub(crate) fn stand(world: &mut MujocoWorld<Nao>, cycles: u32) {
    for _ in 0..cycles {
        world.act(&command(Nao::STAND, 1.0));
    }
}
