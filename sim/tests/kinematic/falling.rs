use core::time::Duration;

use bica_motion::fall::Direction;
use bica_motion::getup::GetUp;
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::{Event, Posture};
use glam::Vec2;

use crate::support::{TOGETHER, alone, glide};

fn world() -> KinematicWorld {
    alone(2, Pose2::new(-1.0, 0.3, 0.7), Vec2::new(2.0, 1.5))
}

/// Leans until the robot falls.
fn fall(world: &mut KinematicWorld, to: Direction) {
    let mut posture = NAO.stand;
    match to {
        Direction::Front | Direction::Back => {
            let lean = if to == Direction::Front { -0.6 } else { 0.6 };
            posture[Joint::LAnklePitch] += lean;
            posture[Joint::RAnklePitch] += lean;
            for _ in 0..60 {
                world.act(&Command::new(posture, 1.0));
            }
        }
        Direction::Left | Direction::Right => {
            let side = if to == Direction::Left { Side::Left } else { Side::Right };
            let mut lifted = TOGETHER;
            lifted[side.index()].2 = 0.03;
            glide(world, TOGETHER, lifted, 10);
            glide(world, lifted, lifted, 50);
        }
    }
}

#[test]
fn fall_goes_to_the_unbalanced_side() {
    for to in Direction::ALL {
        let mut world = world();
        fall(&mut world, to);
        assert_eq!(world.referee().posture(), Posture::Down(to));
        assert_eq!(world.referee().count(|event| *event == Event::Fall(to)), 1);
        for _ in 0..100 {
            world.act(&Command::new(NAO.stand, 1.0));
        }
        let inertial = world.sensors().inertial;
        assert!((inertial.acceleration - to.gravity()).length() < 0.5, "{to:?}: {}", inertial.acceleration);
        assert_eq!(world.sensors().left_foot.total(), 0.0);
    }
}

#[test]
fn robot_falls_after_fifteen_unbalanced_cycles() {
    // The foot is lifted for one cycle more than `cycles`.
    for (cycles, falls) in [(13, 0), (14, 0), (15, 1), (16, 1)] {
        let mut world = world();
        let mut lifted = TOGETHER;
        lifted[0].2 = 0.012;
        glide(&mut world, TOGETHER, lifted, 1);
        glide(&mut world, lifted, lifted, cycles);
        glide(&mut world, TOGETHER, TOGETHER, 30);
        assert_eq!(world.referee().falls(), falls, "{cycles}");
    }
}

#[test]
fn legs_without_stiffness_do_not_carry_robot() {
    let mut world = world();
    for _ in 0..100 {
        world.act(&Command { stiffness: Joints::all(0.0), ..Command::new(NAO.stand, 1.0) });
    }
    assert_eq!(world.referee().falls(), 1);
}

#[test]
fn get_up_restores_stance_in_place() {
    for to in Direction::ALL {
        let mut world = world();
        fall(&mut world, to);
        for _ in 0..100 {
            world.act(&Command::new(NAO.stand, 1.0));
        }
        let lying = world.referee().robot();
        get_up(&mut world, to);
        let end = world.now();
        assert_eq!(world.referee().posture(), Posture::Upright, "{to:?}");
        assert!(world.referee().robot().position.distance(lying.position) < 0.02);
        assert!((world.referee().robot().heading - 0.7).abs() < 0.1);
        let last = world.referee().events().last().expect("an event");
        assert_eq!(last.event, Event::GotUp);
        assert!(last.at < end + Duration::from_millis(200));
        for _ in 0..300 {
            world.act(&Command::new(NAO.stand, 1.0));
        }
        assert_eq!(world.referee().posture(), Posture::Upright);
    }
}

#[test]
fn standing_posture_alone_does_not_get_up() {
    let mut world = world();
    fall(&mut world, Direction::Front);
    for _ in 0..1_000 {
        world.act(&Command::new(NAO.stand, 1.0));
    }
    assert_eq!(world.referee().posture(), Posture::Down(Direction::Front));
}

fn get_up(world: &mut KinematicWorld, lying: Direction) {
    let mut movement = GetUp::new(NAO, lying, 0, world.sensors().angles);
    while !movement.is_done() {
        let (targets, stiffness) = movement.step(&world.sensors().inertial, 0.01);
        world.act(&Command { stiffness: Joints::all(stiffness), ..Command::new(targets, 1.0) });
    }
    for _ in 0..10 {
        world.act(&Command::new(NAO.stand, 1.0));
    }
}
