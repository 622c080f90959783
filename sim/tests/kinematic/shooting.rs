//! Balls that are placed and kicked from outside, and shots at the own goal.

use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Event;
use bica_sim::setup::SetupError;
use bica_sim::shot::{SPEEDS, Shot};
use glam::Vec2;

use crate::support::alone;

/// Lets a world run with a standing robot.
fn wait(world: &mut KinematicWorld, cycles: u32) {
    (0..cycles).for_each(|_| world.act(&Command::new(NAO.stand, 1.0)));
}

#[test]
fn unblocked_shots_are_own_goals() {
    for seed in 0..60 {
        let shot = Shot::draw(seed, 0, &SPEEDS);
        let mut world = alone(seed, Pose2::new(2.0, 1.5, 0.0), shot.from);
        world.set_ball(shot.from, shot.velocity()).expect("a valid shot");
        wait(&mut world, 400);
        assert_eq!(world.referee().own_goals(), 1, "seed {seed}: {shot:?} ends at {}", world.referee().ball());
    }
}

#[test]
fn ball_put_back_by_hand_returns_once() {
    let mut world = alone(1, Pose2::new(-2.0, 0.0, 0.0), Vec2::new(-2.5, 1.0));
    world.set_ball(Vec2::new(0.0, 1.9), Vec2::new(0.0, 1.0)).expect("a valid place");
    wait(&mut world, 60);
    assert_eq!(world.referee().outs(), 1);
    world.set_ball(Vec2::new(0.0, 1.0), Vec2::ZERO).expect("a valid place");
    wait(&mut world, 300);
    assert_eq!(world.referee().ball(), Vec2::new(0.0, 1.0));
    assert_eq!(world.referee().count(|event| matches!(event, Event::BallPlaced { .. })), 0);
}

#[test]
fn impossible_placement_changes_nothing() {
    let mut world = alone(1, Pose2::new(-2.0, 0.0, 0.0), Vec2::ZERO);
    let nan = Vec2::new(f32::NAN, 0.0);
    for (at, velocity, error) in [
        (Vec2::new(9.0, 0.0), Vec2::ZERO, SetupError::BallOffCarpet(Vec2::new(9.0, 0.0))),
        (Vec2::new(3.05, 0.72), Vec2::ZERO, SetupError::BallInGoal(Vec2::new(3.05, 0.72))),
        (Vec2::new(-2.0, 0.1), Vec2::ZERO, SetupError::BallUnderRobot(Vec2::new(-2.0, 0.1))),
        (Vec2::X, Vec2::new(f32::INFINITY, 0.0), SetupError::BallVelocity(Vec2::new(f32::INFINITY, 0.0))),
    ] {
        assert_eq!(world.set_ball(at, velocity), Err(error));
    }
    assert!(matches!(world.set_ball(nan, Vec2::ZERO), Err(SetupError::BallOffCarpet(_))));
    assert_eq!((world.referee().ball(), world.referee().ball_velocity()), (Vec2::ZERO, Vec2::ZERO));
    wait(&mut world, 10);
    assert_eq!(world.referee().ball(), Vec2::ZERO);
}
