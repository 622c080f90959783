//! Positions at which a person can place the ball or the robot.

use bica_motion::model::simulation::SimulatedModel;
use glam::Vec2;

use crate::field::{BALL_RADIUS, CORNER};
use crate::obstacle::GOALS;
use crate::referee::{Posture, Referee};

/// Reasons for which an object cannot be placed at a position.
pub(crate) const OFF_FIELD: &str = "this is beyond the lines of the field";
pub(crate) const IN_POST: &str = "a goal post is there";
pub(crate) const IN_ROBOT: &str = "a robot is there";
const ON_BALL: &str = "the ball is there";

/// Checks that the ball can lie at a position, m, field frame: in play, and apart from all posts and robots.
pub(crate) fn check_ball(model: &'static SimulatedModel, at: Vec2, referee: &Referee) -> Result<(), &'static str> {
    let own_radius = match referee.posture() {
        Posture::Upright => model.extents.standing,
        Posture::Down(_) => model.extents.lying,
    };
    check(model, at, BALL_RADIUS, referee)?;
    if referee.robot().position.distance(at) < own_radius + BALL_RADIUS { Err(IN_ROBOT) } else { Ok(()) }
}

/// Checks that the robot can stand at a position, m, field frame: in play, and apart from posts, other robots and the ball.
pub(crate) fn check_robot(model: &'static SimulatedModel, at: Vec2, referee: &Referee) -> Result<(), &'static str> {
    let radius = model.extents.standing;
    check(model, at, radius, referee)?;
    if referee.ball().distance(at) < radius + BALL_RADIUS { Err(ON_BALL) } else { Ok(()) }
}

/// Checks that there is room for something with a radius, m, apart from the robot and the ball.
fn check(model: &'static SimulatedModel, at: Vec2, radius: f32, referee: &Referee) -> Result<(), &'static str> {
    // False for NaN.
    let is_on_field = at.x.abs() <= CORNER.x && at.y.abs() <= CORNER.y;
    if !is_on_field {
        return Err(OFF_FIELD);
    }
    if GOALS.iter().any(|obstacle| obstacle.overlap(at, radius).is_some()) {
        return Err(IN_POST);
    }
    let mut others = referee.others().iter();
    if others.any(|other| other.position.distance(at) < model.extents.standing + radius) {
        return Err(IN_ROBOT);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use bica_field::GoalColour;
    use bica_motion::fall::Direction;
    use bica_motion::pose::Pose2;

    use super::*;
    use crate::TEST_MODEL;

    fn referee(posture: Posture) -> Referee {
        let other = Pose2::new(1.0, 1.0, 0.0);
        let robot = Pose2::new(-2.0, 0.0, 0.0);
        let mut referee = Referee::new(GoalColour::Yellow, robot, Vec2::ZERO, vec![other]);
        referee.set_robot(robot, posture);
        referee
    }

    #[test]
    fn field_includes_lines_and_excludes_goals() {
        let referee = referee(Posture::Upright);
        for at in [(3.0, 0.0), (-3.0, 2.0), (0.0, -2.0), (-3.0, 0.6), (3.0, 0.8)] {
            assert_eq!(check_ball(TEST_MODEL, Vec2::from(at), &referee), Ok(()), "{at:?}");
        }
        for at in [(3.001, 0.0), (-3.2, 0.0), (0.0, 2.001), (f32::NAN, 0.0), (0.0, f32::NEG_INFINITY)] {
            assert_eq!(check_ball(TEST_MODEL, Vec2::from(at), &referee), Err(OFF_FIELD), "{at:?}");
        }
    }

    #[test]
    fn post_or_robot_occupies_its_place() {
        let (standing, lying) = (referee(Posture::Upright), referee(Posture::Down(Direction::Front)));
        let post = Vec2::new(3.0, -0.7);
        assert_eq!(check_ball(TEST_MODEL, post, &standing), Err(IN_POST));
        for (at, standing_refuses) in [((1.1, 1.1), true), ((-2.0, 0.18), true), ((-2.0, 0.19), false)] {
            let at = Vec2::from(at);
            assert_eq!(check_ball(TEST_MODEL, at, &standing) == Err(IN_ROBOT), standing_refuses, "{at}");
            assert_eq!(check_ball(TEST_MODEL, at, &lying), Err(IN_ROBOT), "{at}");
        }
        assert_eq!(check_ball(TEST_MODEL, Vec2::new(-1.5, 0.0), &lying), Ok(()));
    }

    #[test]
    fn robot_stands_apart_from_posts_robots_and_ball() {
        let referee = referee(Posture::Upright);
        let check = |at: (f32, f32)| check_robot(TEST_MODEL, Vec2::from(at), &referee);
        assert_eq!((check((-2.0, 0.1)), check((0.5, -1.0))), (Ok(()), Ok(())), "its own place is free");
        assert_eq!((check((0.1, 0.1)), check((1.1, 1.2))), (Err(ON_BALL), Err(IN_ROBOT)));
        assert_eq!((check((3.0, 0.6)), check((0.0, 2.1))), (Err(IN_POST), Err(OFF_FIELD)));
    }
}
