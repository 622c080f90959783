//! Equal seeds give equal measurements, bit for bit.

use bica_motion::joints::Joint;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::robot::Command;
use bica_sim::World;
use bica_sim::setup::Setup;
use glam::Vec2;

use crate::support::{blind, world};

/// Runs a world with motions and a push. Returns all measurements of the body.
fn measurements(seed: u64) -> Vec<u32> {
    let mut world = world(&Setup { seed, robots: 2, ..Setup::default() }, &blind());
    let mut words = Vec::new();
    for cycle in 0..300 {
        let mut targets = Nao::STAND;
        targets[Joint::LHipPitch] -= 0.3 * (cycle as f32 * 0.2).sin();
        if cycle == 150 {
            world.push(Vec2::new(0.3, -0.9));
        }
        world.act(&Command::new(targets, 0.8));
        let sensors = world.sensors();
        let feet = [sensors.left_foot.total(), sensors.right_foot.total()];
        let inertial = sensors.inertial.gyro.to_array().into_iter().chain(sensors.inertial.acceleration.to_array());
        words.extend(sensors.angles.0.into_iter().chain(feet).chain(inertial).map(f32::to_bits));
    }
    words
}

#[test]
fn same_seed_is_same_measurements() {
    assert!(measurements(3) == measurements(3));
    assert!(measurements(3) != measurements(4));
}
