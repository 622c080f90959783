//! Standing, pushes and falls.

use bica_motion::fall::Direction;
use bica_motion::joints::Joint;
use bica_motion::model::simulation::{HUMANOIDS, NAO};
use bica_motion::robot::Command;
use bica_sim::World;
use bica_sim::mujoco::{MujocoWorld, Physics};
use bica_sim::referee::{Event, Posture};
use bica_sim::setup::Setup;
use glam::Vec2;

use crate::support::{alone, blind, stand};

#[test]
fn a_standing_robot_does_not_drift() {
    let mut world = alone(1, &blind());
    stand(&mut world, 1_000);
    let robot = world.referee().robot();
    assert_eq!(world.referee().posture(), Posture::Upright);
    assert!(robot.position.length() < 0.01 && robot.heading.abs() < 0.02, "{robot:?}");
}

#[test]
fn each_humanoid_stands_and_turns_its_head() {
    for model in HUMANOIDS {
        let physics = Physics { cameras: false, ..Physics::of(model) };
        let mut world = MujocoWorld::new(model, &Setup::default(), &physics).unwrap();
        let mut targets = model.stand;
        targets[Joint::HeadYaw] = 0.5;
        (0..500).for_each(|_| world.act(&Command::new(targets, 1.0)));
        assert_eq!((world.referee().posture(), world.referee().falls()), (Posture::Upright, 0), "{}", model.name);
        let sensors = world.sensors();
        for joint in model.joints {
            let angle = sensors.angles[*joint];
            assert!((angle - targets[*joint]).abs() < 0.1, "{}: {joint:?} is at {angle}", model.name);
        }
    }
}

#[test]
fn robot_falls_in_direction_of_push() {
    for (push, fall) in [
        (Vec2::new(2.5, 0.0), Direction::Front),
        (Vec2::new(-2.5, 0.0), Direction::Back),
        (Vec2::new(0.0, 3.0), Direction::Left),
        (Vec2::new(0.0, -3.0), Direction::Right),
    ] {
        let mut world = alone(1, &blind());
        stand(&mut world, 100);
        world.add_velocity(push);
        stand(&mut world, 200);
        assert_eq!(world.referee().posture(), Posture::Down(fall));
        assert_eq!(world.referee().falls(), 1);
    }
}

#[test]
fn legs_without_stiffness_do_not_carry_robot() {
    let mut world = alone(1, &blind());
    for _ in 0..300 {
        world.act(&Command::new(NAO.stand, 0.0));
    }
    assert_eq!(world.referee().falls(), 1);
    assert_eq!(world.referee().count(|event| *event == Event::GotUp), 0);
}

#[test]
fn slippery_floor_increases_the_displacement() {
    let slide = |friction| {
        let mut world = alone(1, &Physics { friction, ..blind() });
        stand(&mut world, 50);
        world.add_velocity(Vec2::new(0.0, 0.35));
        stand(&mut world, 100);
        world.referee().robot().position.y
    };
    assert!(slide(0.1) > 2.0 * slide(1.0) + 0.005, "{} {}", slide(0.1), slide(1.0));
}
