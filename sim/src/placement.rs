//! Places at which a person can put the ball.

use core::fmt;

use bica_motion::model::simulation::SimulatedModel;
use glam::Vec2;

use crate::field::{BALL_RADIUS, CORNER};
use crate::obstacle::GOALS;
use crate::referee::{Posture, Referee};

/// The reason why the ball cannot be placed at a position, m, field frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlacementError {
    /// The position is beyond the lines of the field, or not finite.
    OffField(Vec2),
    /// The ball would overlap a goal post.
    InPost(Vec2),
    /// The ball would overlap a robot.
    InRobot(Vec2),
}

impl fmt::Display for PlacementError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Self::OffField(at) | Self::InPost(at) | Self::InRobot(at)) = self;
        write!(f, "the ball cannot be placed at x {}, y {} m: ", at.x, at.y)?;
        match self {
            Self::OffField(_) => {
                let Vec2 { x, y } = CORNER;
                write!(f, "x must be from -{x} to {x} m, y from -{y} to {y} m")
            }
            Self::InPost(_) => f.write_str("a goal post is there"),
            Self::InRobot(_) => f.write_str("a robot is there"),
        }
    }
}

impl core::error::Error for PlacementError {}

/// Checks that the ball can lie at a position, m, field frame: in play, and apart from all posts and robots.
pub(crate) fn check<M: SimulatedModel>(at: Vec2, referee: &Referee) -> Result<(), PlacementError> {
    // False for NaN.
    let is_on_field = at.x.abs() <= CORNER.x && at.y.abs() <= CORNER.y;
    if !is_on_field {
        return Err(PlacementError::OffField(at));
    }
    if GOALS.iter().any(|obstacle| obstacle.overlap(at, BALL_RADIUS).is_some()) {
        return Err(PlacementError::InPost(at));
    }
    let own_radius = match referee.posture() {
        Posture::Upright => M::EXTENTS.standing,
        Posture::Down(_) => M::EXTENTS.lying,
    };
    let others = referee.others().iter().map(|other| (other.position, M::EXTENTS.standing));
    let mut robots = others.chain([(referee.robot().position, own_radius)]);
    if robots.any(|(robot, radius)| robot.distance(at) < radius + BALL_RADIUS) {
        return Err(PlacementError::InRobot(at));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use bica_field::GoalColour;
    use bica_motion::fall::Direction;
    use bica_motion::pose::Pose2;

    use super::*;
    use crate::TestModel;

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
            assert_eq!(check::<TestModel>(Vec2::from(at), &referee), Ok(()), "{at:?}");
        }
        for at in [(3.001, 0.0), (-3.2, 0.0), (0.0, 2.001), (f32::NAN, 0.0), (0.0, f32::NEG_INFINITY)] {
            let refused = check::<TestModel>(Vec2::from(at), &referee);
            assert!(matches!(refused, Err(PlacementError::OffField(_))), "{at:?}");
        }
        let error = PlacementError::OffField(Vec2::new(3.5, -1.0));
        let text = "the ball cannot be placed at x 3.5, y -1 m: x must be from -3 to 3 m, y from -2 to 2 m";
        assert_eq!(error.to_string(), text);
    }

    #[test]
    fn post_or_robot_occupies_its_place() {
        let (standing, lying) = (referee(Posture::Upright), referee(Posture::Down(Direction::Front)));
        let post = Vec2::new(3.0, -0.7);
        assert_eq!(check::<TestModel>(post, &standing), Err(PlacementError::InPost(post)));
        for (at, standing_refuses) in [((1.1, 1.1), true), ((-2.0, 0.18), true), ((-2.0, 0.19), false)] {
            let at = Vec2::from(at);
            assert_eq!(check::<TestModel>(at, &standing) == Err(PlacementError::InRobot(at)), standing_refuses, "{at}");
            assert_eq!(check::<TestModel>(at, &lying), Err(PlacementError::InRobot(at)), "{at}");
        }
        assert_eq!(check::<TestModel>(Vec2::new(-1.5, 0.0), &lying), Ok(()));
    }
}
