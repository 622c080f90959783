//! A simulation that breaks must end with a reason, and must never reset silently.

use bica_motion::model::simulation::NAO;
use bica_motion::robot::Command;
use bica_sim::World;
use glam::Vec2;

use crate::support::{alone, blind, stand};

#[test]
fn pushes_of_a_cycle_do_not_break_the_simulation() {
    let mut world = alone(1, &blind());
    stand(&mut world, 50);
    (0..20).for_each(|_| world.add_velocity(Vec2::X * 0.8));
    let speed = |world: &mut bica_sim::mujoco::MujocoWorld| {
        let before = world.referee().robot().position;
        stand(world, 1);
        100.0 * world.referee().robot().position.distance(before)
    };
    assert!(speed(&mut world) < 2.6);
    stand(&mut world, 200);
    assert_eq!(world.failure(), None);
}

#[test]
fn impossible_speed_ends_the_simulation() {
    let mut world = alone(1, &blind());
    stand(&mut world, 50);
    world.kick_ball(Vec2::X * 1e6);
    stand(&mut world, 1);
    let reason = world.failure().expect("a reason").to_owned();
    assert!(reason.contains("0.500 s") && reason.contains("qvel"), "{reason}");
    let (robot, ball) = (world.referee().robot(), world.referee().ball());
    world.act(&Command::new(NAO.stand, 1.0));
    assert_eq!((world.failure(), world.referee().robot(), world.referee().ball()), (Some(&*reason), robot, ball));
    assert!(!std::path::Path::new("MUJOCO_LOG.TXT").exists());
}
