//! A second robot model, with other joints, lengths, masses and motors.

use bica_motion::joints::Joint;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_sim::mujoco::{MujocoWorld, Physics};
use bica_sim::referee::Posture;
use bica_sim::setup::{Setup, Start};
use bica_sim::{SpectatorCamera, SpectatorView, World};
use glam::{Vec2, Vec3};

use crate::tall::TALL;

#[test]
fn second_model_stands_measures_and_turns_its_head() {
    let start = Some(Start { robot: Pose2::ORIGIN, ball: Vec2::new(1.0, 1.5) });
    let setup = Setup { start, ..Setup::default() };
    let physics = Physics::of(TALL);
    assert_eq!((physics.dead_time, physics.torque_limit), (0.02, 20.0));
    let mut world = MujocoWorld::new(TALL, &setup, &physics).unwrap();
    let mut targets = TALL.stand;
    targets[Joint::HeadYaw] = 0.5;
    for _ in 0..500 {
        world.act(&Command::new(targets, 1.0));
    }
    let referee = world.referee();
    assert_eq!((referee.posture(), referee.falls()), (Posture::Upright, 0));
    assert!(referee.robot().position.length() < 0.03, "{:?}", referee.robot());
    let sensors = world.sensors();
    let force = sensors.left_foot.total() + sensors.right_foot.total();
    assert!((force - 20.5 * 9.81).abs() < 4.0, "{force} N");
    for joint in TALL.joints.iter().copied() {
        let angle = sensors.angles[joint];
        assert!((angle - targets[joint]).abs() < 0.06, "{joint:?} is at {angle}, not {}", targets[joint]);
    }
    let camera = SpectatorCamera { eye: Vec3::new(2.0, 0.0, 0.6), target: Vec3::new(0.0, 0.0, 0.3) };
    world.render_from(&camera, 64, 48).expect("the shells are in an MJCF file");
}
