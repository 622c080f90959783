//! Detection of falls, protection, and getting up.

use bica_motion::fall::{Direction, FallDetector, FallState};
use bica_motion::getup::{GetUp, protection};
use bica_motion::model::simulation::NAO;
use bica_motion::robot::Command;
use bica_sim::mujoco::MujocoWorld;
use bica_sim::referee::Posture;
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

use crate::support::{alone, blind, stand};

/// Pushes the robot over. Checks that the fall is detected before the impact, commands the protective posture, and returns the
/// detected side on which the robot lies.
fn fall(world: &mut MujocoWorld, push: Vec2) -> Direction {
    stand(world, 50);
    world.add_velocity(push);
    let (mut detector, mut detected, mut hit) = (FallDetector::new(NAO), false, false);
    for _ in 0..300 {
        hit |= world.body_touches_floor();
        match detector.step(&world.sensors().inertial, CYCLE_SECONDS) {
            FallState::Upright => stand(world, 1),
            FallState::Falling(direction) => {
                assert!(detected || !hit, "{push}: impact before detection");
                detected = true;
                let brace = protection(NAO, direction);
                world.act(&Command::new(brace.posture, brace.stiffness));
            }
            FallState::Fallen(direction) => return direction,
        }
    }
    panic!("{push}: no fall");
}

fn get_up(world: &mut MujocoWorld, lying: Direction, failures: u8) {
    let mut movement = GetUp::new(NAO, lying, failures, world.sensors().angles);
    while !movement.is_done() {
        let (targets, stiffness) = movement.step(&world.sensors().inertial, CYCLE_SECONDS);
        world.act(&Command::new(targets, stiffness));
    }
}

#[test]
fn either_motion_gets_up_from_front_and_back() {
    for (push, lying) in [(Vec2::new(2.3, 0.0), Direction::Front), (Vec2::new(-2.3, 0.0), Direction::Back)] {
        for failures in [0, 1] {
            let mut world = alone(failures.into(), &blind());
            assert_eq!(fall(&mut world, push), lying);
            get_up(&mut world, lying, failures);
            assert_eq!(world.referee().posture(), Posture::Upright, "{lying:?}, {failures}");
        }
    }
}

#[test]
fn robot_gets_up_from_its_side() {
    for side in [1.0, -1.0] {
        let mut world = alone(1, &blind());
        let lying = fall(&mut world, Vec2::new(0.0, 2.3 * side));
        get_up(&mut world, lying, 0);
        if world.referee().posture() != Posture::Upright {
            get_up(&mut world, Direction::Front, 1);
        }
        assert_eq!(world.referee().posture(), Posture::Upright, "{side}");
    }
}

#[test]
fn robot_without_stiffness_after_motion_rolls_over() {
    for (push, lying, turned) in [(2.3, Direction::Front, Direction::Back), (-2.3, Direction::Back, Direction::Front)] {
        for failures in [2, 5] {
            let mut world = alone(3, &blind());
            assert_eq!(fall(&mut world, Vec2::new(push, 0.0)), lying);
            get_up(&mut world, lying, failures);
            for _ in 0..50 {
                world.act(&Command::new(NAO.stand, 0.0));
            }
            let acceleration = world.sensors().inertial.acceleration;
            assert!((acceleration - turned.gravity()).length() < 7.0, "{lying:?}, {failures}: {acceleration}");
        }
    }
}
