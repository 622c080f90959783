//! Tests of objects that a person places.

use bica_core::action::perform;
use bica_motion::joints::Joint;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Event;
use bica_sim::setup::Setup;
use glam::Vec2;

use crate::support::alone;

fn wait(world: &mut KinematicWorld, cycles: u32) {
    (0..cycles).for_each(|_| world.act(&Command::new(NAO.stand, 1.0)));
}

#[test]
fn placed_ball_lies_still_and_is_no_event() {
    let mut world = KinematicWorld::new(NAO, &Setup { seed: 3, robots: 8, ..Setup::default() }).expect("valid");
    let (mut placed, mut refused) = (0, 0);
    for row in -22..=22 {
        for column in -32..=32 {
            let (at, before) = (Vec2::new(column as f32, row as f32) * 0.1, world.referee().ball());
            let result = world.put_ball(at);
            placed += usize::from(result.is_ok());
            refused += usize::from(result == Err("a robot is there"));
            wait(&mut world, 3);
            let referee = world.referee();
            assert_eq!(referee.ball(), if result.is_ok() { at } else { before }, "{at}: {result:?}");
            assert_eq!((referee.ball_velocity(), referee.events()), (Vec2::ZERO, &[][..]), "{at}: {result:?}");
        }
    }
    assert!(placed > 2000 && refused > 10, "{placed} placed, {refused} in a robot");
}

#[test]
fn rolling_ball_that_is_placed_stops() {
    let mut world = alone(1, Pose2::new(-2.0, 0.0, 0.0), Vec2::ZERO);
    world.set_ball(Vec2::ZERO, Vec2::new(1.0, 0.5)).expect("a valid shot");
    wait(&mut world, 20);
    world.put_ball(Vec2::new(2.9, 0.0)).expect("a free place");
    wait(&mut world, 300);
    assert_eq!((world.referee().ball(), world.referee().events()), (Vec2::new(2.9, 0.0), &[][..]));
}

#[test]
fn placement_after_goal_cancels_return() {
    let mut world = alone(1, Pose2::new(-2.0, 0.0, 0.0), Vec2::ZERO);
    world.set_ball(Vec2::new(2.8, 0.0), Vec2::new(1.5, 0.0)).expect("a valid shot");
    wait(&mut world, 100);
    assert_eq!(world.referee().goals(), 1);
    let at = Vec2::new(1.0, -0.5);
    world.put_ball(at).expect("a free place");
    wait(&mut world, 400);
    assert_eq!((world.referee().ball(), world.referee().goals()), (at, 1));
    assert_eq!(world.referee().count(|event| matches!(event, Event::BallPlaced { .. })), 0);
}

#[test]
fn refused_placement_leaves_a_rolling_ball() {
    let rolling = || {
        let mut world = alone(1, Pose2::new(-2.0, 0.0, 0.0), Vec2::ZERO);
        world.set_ball(Vec2::ZERO, Vec2::new(1.0, 0.5)).expect("a valid shot");
        world
    };
    let (mut world, mut undisturbed) = (rolling(), rolling());
    for at in [Vec2::new(3.3, 0.0), Vec2::new(-2.0, 0.1), Vec2::new(3.0, 0.7), Vec2::NAN] {
        world.put_ball(at).expect_err("no place for the ball");
        wait(&mut world, 10);
        wait(&mut undisturbed, 10);
    }
    assert_eq!(world.referee(), undisturbed.referee());
}

#[test]
fn image_shows_ball_where_it_was_placed() {
    let mut world = alone(1, Pose2::new(-2.0, 0.0, 0.0), Vec2::new(2.0, 1.5));
    let pixels = |world: &mut KinematicWorld| world.sensors().image.expect("the first cycle has one").yuyv.to_vec();
    let mut placed = world.clone();
    placed.put_ball(Vec2::new(-1.0, 0.0)).expect("a free place");
    let mut there = alone(1, Pose2::new(-2.0, 0.0, 0.0), Vec2::new(-1.0, 0.0));
    let image = pixels(&mut placed);
    assert_eq!(image, pixels(&mut there));
    assert_ne!(image, pixels(&mut world));
}

#[test]
fn moved_limb_follows_operator_then_program() {
    use bica_core::Value::{Bool, Choice, F32};
    let mut world = alone(1, Pose2::new(-2.0, 0.0, 0.0), Vec2::new(2.0, 1.5));
    let pitch = |world: &mut KinematicWorld| world.sensors().angles[Joint::RShoulderPitch];
    let stand = NAO.stand[Joint::RShoulderPitch];
    let up = |seconds| {
        [Choice(2), F32(seconds), F32(1.0), Bool(false), F32(-1.0), F32(-0.2), F32(0.5), F32(0.5), F32(0.0), F32(0.0)]
    };
    for seconds in [1.0, 0.5] {
        perform(Some(World::actions(&mut world)), "move_limb", &up(seconds)).expect("an arm that moves");
    }
    wait(&mut world, 140);
    assert!((pitch(&mut world) + 1.0).abs() < 0.05, "{}", pitch(&mut world));
    assert!((world.sensors().angles[Joint::LShoulderPitch] - NAO.stand[Joint::LShoulderPitch]).abs() < 0.05);
    wait(&mut world, 150);
    assert!((pitch(&mut world) - stand).abs() < 0.05, "{}", pitch(&mut world));
    // Placing the robot discards its waiting motions.
    perform(Some(World::actions(&mut world)), "move_limb", &up(1.0)).expect("an arm that moves");
    world.put_robot(Pose2::new(-1.0, 0.0, 0.0)).expect("a free place");
    wait(&mut world, 100);
    assert!((pitch(&mut world) - stand).abs() < 0.05, "{}", pitch(&mut world));
}
