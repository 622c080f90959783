use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Velocity, Walk, in_walk_kick_foot};
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Event;
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

use crate::support::{TOGETHER, alone, glide, swayed};

/// Stands on one foot, swings the other one back and then forward by 0.16 m in 0.12 s.
fn kick(world: &mut KinematicWorld, foot: Side) {
    let swung = |x: f32, lift: f32| {
        let mut feet = swayed(foot.other());
        feet[foot.index()].0 += x;
        feet[foot.index()].2 = lift;
        feet
    };
    glide(world, TOGETHER, swung(0.0, 0.0), 50);
    glide(world, swung(0.0, 0.0), swung(-0.07, 0.03), 40);
    glide(world, swung(-0.07, 0.03), swung(0.09, 0.02), 12);
    glide(world, swung(0.09, 0.02), swung(0.0, 0.02), 30);
    glide(world, swung(0.0, 0.02), swung(0.0, 0.0), 30);
}

fn stand(world: &mut KinematicWorld, seconds: u32) {
    for _ in 0..100 * seconds {
        world.act(&Command::new(NAO.stand, 1.0));
    }
}

#[test]
fn kicked_ball_follows_swing_and_scores() {
    for foot in Side::BOTH {
        let robot = Pose2::new(1.6, 0.0, 0.0);
        let ball = robot.place(Vec2::new(0.17, 0.055 * foot.sign()));
        let mut world = alone(4, robot, ball);
        kick(&mut world, foot);
        let speed = world.referee().ball_velocity();
        // The foot has a mean speed of 1.3 m/s and accelerates; with its restitution of 0.5 the ball leaves 1.5 times as fast.
        assert!((2.0..3.2).contains(&speed.x) && speed.y.abs() < 0.1 * speed.x, "{foot:?}: {speed}");
        assert_eq!(world.referee().count(|event| *event == Event::Touch { foot }), 1);
        assert_eq!(world.referee().count(|event| matches!(event, Event::Kick { foot: by, .. } if *by == foot)), 1);
        stand(&mut world, 2);
        assert_eq!(world.referee().goals(), 1);
        assert_eq!((world.referee().own_goals(), world.referee().falls()), (0, 0));
        stand(&mut world, 4);
        assert_eq!(world.referee().ball(), Vec2::ZERO);
        assert_eq!(world.referee().goals(), 1);
    }
}

#[test]
fn kick_while_walking_moves_ball_straight_ahead() {
    for foot in Side::BOTH {
        let half = NAO.kinematic_profile.gait.half_spacing;
        let robot = Pose2::new(-1.5, 0.0, 0.0);
        let ball = robot.place(Vec2::new(0.44, foot.sign() * half));
        let mut world = alone(4, robot, ball);
        let mut walk = Walk::new(NAO, &NAO.kinematic_profile.gait);
        let mut kicked = false;
        for _ in 0..1000 {
            let at = world.referee().robot().locate(world.referee().ball());
            if let Some(foot) = in_walk_kick_foot(at, &NAO.kinematic_profile.gait) {
                walk.request_kick(foot);
            }
            kicked |= at.x > 0.5 || world.referee().ball_velocity().x > 0.3;
            let ahead = if kicked { Velocity::ZERO } else { Velocity::new(0.15, 0.0, 0.0) };
            let targets = walk.step(ahead, &Feedback::from(&world.sensors()), CYCLE_SECONDS).joints(NAO);
            world.act(&Command::new(targets, 1.0));
        }
        let moved = world.referee().ball() - ball;
        assert!((1.5..4.0).contains(&moved.x) && moved.y.abs() < 0.1 * moved.x, "{foot:?}: {moved}");
        assert_eq!(world.referee().falls(), 0);
    }
}
