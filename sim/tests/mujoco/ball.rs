//! Motion of the ball, and the rules.

use bica_motion::pose::Pose2;
use bica_sim::World;
use bica_sim::referee::Event;
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

use crate::support::{blind, stand, world};

fn rolling(seed: u64, from: Vec2, velocity: Vec2) -> bica_sim::mujoco::MujocoWorld {
    let start = Some(Start { robot: Pose2::new(-2.0, 1.5, 0.0), ball: from });
    let mut world = world(&Setup { seed, goalkeeper: false, start, ..Setup::default() }, &blind());
    world.kick_ball(velocity);
    world
}

#[test]
fn rolling_resistance_limits_the_distance() {
    for seed in 0..4 {
        let mut world = rolling(seed, Vec2::new(-1.5, -1.0), Vec2::new(1.0, 0.0));
        stand(&mut world, 600);
        let rolled = world.referee().ball().x + 1.5;
        assert!((1.0 / (2.0 * 0.4) * 0.9..=1.0 / (2.0 * 0.3) * 1.1).contains(&rolled), "seed {seed}: {rolled}");
        assert!(world.referee().ball_velocity().length() < 0.01);
    }
}

#[test]
fn goal_returns_ball_to_centre_mark() {
    let mut world = rolling(1, Vec2::new(2.3, 0.3), Vec2::new(1.5, 0.0));
    stand(&mut world, 600);
    let events: Vec<Event> = world.referee().events().iter().map(|timed| timed.event).collect();
    assert_eq!(events, [Event::Goal, Event::BallPlaced { at: Vec2::ZERO }]);
    assert!(world.referee().ball().length() < 0.01);
}

#[test]
fn posts_and_nets_stop_the_ball() {
    let mut at_post = rolling(1, Vec2::new(2.4, 0.7), Vec2::new(2.0, 0.0));
    stand(&mut at_post, 60);
    let after = at_post.referee().ball_velocity().x;
    assert!((-1.6..-0.1).contains(&after), "{after} m/s after a post hit at less than 2 m/s");
    let mut in_net = rolling(1, Vec2::new(2.5, 0.0), Vec2::new(3.0, 0.4));
    stand(&mut in_net, 200);
    assert!((3.1..3.5).contains(&in_net.referee().ball().x), "{}", in_net.referee().ball());
}

#[test]
fn placed_ball_lies_still_and_is_no_event() {
    let mut world = rolling(1, Vec2::new(-1.5, -1.0), Vec2::new(1.0, 0.0));
    stand(&mut world, 20);
    for at in [Vec2::new(3.0, 0.0), Vec2::new(-1.6, 1.5), Vec2::new(0.4, -2.0)] {
        world.put_ball(at).expect("a free place");
        assert_eq!((world.referee().ball(), world.referee().ball_velocity()), (at, Vec2::ZERO));
        stand(&mut world, 100);
        assert!((world.referee().ball() - at).length() < 0.005, "{at}: {}", world.referee().ball());
    }
    for at in [Vec2::new(3.2, 0.0), Vec2::new(-2.0, 1.4), Vec2::new(3.0, 0.7)] {
        world.put_ball(at).expect_err("no place for the ball");
    }
    assert_eq!(world.referee().events(), []);
    assert!((world.referee().ball() - Vec2::new(0.4, -2.0)).length() < 0.005);
}

#[test]
fn placement_after_out_cancels_return() {
    let mut world = rolling(1, Vec2::new(0.5, -1.6), Vec2::new(0.0, -1.2));
    while world.referee().outs() == 0 {
        stand(&mut world, 1);
    }
    let at = Vec2::new(1.0, 1.0);
    world.put_ball(at).expect("a free place");
    stand(&mut world, 300);
    assert!((world.referee().ball() - at).length() < 0.005, "{}", world.referee().ball());
    assert_eq!(world.referee().events().len(), 1);
}
