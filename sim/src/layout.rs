//! Start positions and conditions of a game, drawn from its seed.

use core::f32::consts::PI;

use bica_motion::pose::{Pose2, rotate};
use glam::Vec2;

use crate::field::{CORNER, POST};
use crate::random::Random;
use crate::setup::{Setup, Start};
use bica_field::GoalColour;

/// Start positions and conditions of a game.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Layout {
    /// Start positions of robot and ball.
    pub(crate) start: Start,
    /// Colour of the goal at positive x.
    pub(crate) attacks: GoalColour,
    /// Deceleration of the ball by rolling resistance, m/s².
    pub(crate) rolling_deceleration: f32,
    /// Other robots; the goalkeeper first if there is one.
    pub(crate) others: Vec<OtherRobot>,
    /// Whether the other robots move, as in a match.
    pub(crate) others_move: bool,
}

/// A robot that stands still on the field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OtherRobot {
    pub(crate) pose: Pose2,
    /// Whether it belongs to the team of the simulated robot.
    pub(crate) teammate: bool,
}

impl Layout {
    pub(crate) fn new(setup: &Setup, random: &mut Random) -> Self {
        let drawn = if random.chance(0.5) { GoalColour::Yellow } else { GoalColour::SkyBlue };
        let attacks = setup.attacks.unwrap_or(drawn);
        let rolling_deceleration = random.between(0.3, 0.4);
        let drawn = draw_start(random);
        let start = setup.start.unwrap_or(drawn);
        let keeper = draw_goalkeeper(random);
        let mut others = Vec::new();
        others.extend(setup.goalkeeper.then_some(keeper));
        for index in 0..setup.robots {
            others.extend(draw_other(&start, &others, index % 2 == 0, random));
        }
        Self { start, attacks, rolling_deceleration, others, others_move: false }
    }
}

/// Draws a ball position in the attacked half and a robot 0.8 to 2.2 m from it with any heading.
fn draw_start(random: &mut Random) -> Start {
    let ball = Vec2::new(random.between(0.3, 1.6), random.between(-1.0, 1.0));
    let heading = random.between(-PI, PI);
    loop {
        let away = rotate(Vec2::X, random.between(-PI, PI)) * random.between(0.8, 2.2);
        let position = ball + away;
        if position.x.abs() < CORNER.x - 0.4 && position.y.abs() < CORNER.y - 0.3 {
            return Start { robot: Pose2 { position, heading }, ball };
        }
    }
}

/// Draws a goalkeeper on the goal line, 0.08 to 0.28 m beside the centre of the goal.
fn draw_goalkeeper(random: &mut Random) -> OtherRobot {
    let side = random.between(0.08, 0.28) * if random.chance(0.5) { 1.0 } else { -1.0 };
    let pose = Pose2::new(CORNER.x - random.between(0.02, 0.12), side, PI + random.between(-0.2, 0.2));
    OtherRobot { pose, teammate: false }
}

/// Draws a place at least 0.5 m from the paths robot to ball and ball to goal and from other robots; `None` if none is found.
fn draw_other(start: &Start, others: &[OtherRobot], teammate: bool, random: &mut Random) -> Option<OtherRobot> {
    let goal = Vec2::new(POST.x, 0.0);
    for _ in 0..200 {
        let position = Vec2::new(random.between(-2.7, 2.7), random.between(-1.8, 1.8));
        let heading = random.between(-PI, PI);
        let clear = distance_to_path(position, start.robot.position, start.ball) > 0.5
            && distance_to_path(position, start.ball, goal) > 0.5
            && others.iter().all(|other| other.pose.position.distance(position) > 0.5);
        if clear {
            return Some(OtherRobot { pose: Pose2 { position, heading }, teammate });
        }
    }
    None
}

fn distance_to_path(point: Vec2, from: Vec2, to: Vec2) -> f32 {
    let along = to - from;
    let t = ((point - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    point.distance(from + t * along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;
    use crate::random::Stream;

    #[test]
    fn random_starts_are_valid() {
        let mut yellow = 0;
        for seed in 0..500 {
            let setup = Setup { seed, robots: 8, ..Setup::default() };
            let layout = Layout::new(&setup, &mut Random::new(seed, Stream::Start));
            let Start { robot, ball } = layout.start;
            assert!((0.3..=1.6).contains(&ball.x) && ball.y.abs() <= 1.0);
            assert!((0.8..=2.2).contains(&robot.position.distance(ball)));
            assert_eq!(Setup { start: Some(layout.start), ..setup }.check(TEST_MODEL), Ok(()));
            assert!(layout.others.len() >= 8, "seed {seed}: {}", layout.others.len());
            assert!((0.3..=0.4).contains(&layout.rolling_deceleration));
            yellow += usize::from(layout.attacks == GoalColour::Yellow);
        }
        assert!((200..300).contains(&yellow), "{yellow}");
    }

    #[test]
    fn given_start_changes_nothing_else_in_layout() {
        let drawn = Layout::new(&Setup::default(), &mut Random::new(0, Stream::Start));
        let start = Start { robot: Pose2::new(-1.0, 0.0, 0.0), ball: Vec2::new(0.0, 0.5) };
        let setup = Setup { start: Some(start), ..Setup::default() };
        let given = Layout::new(&setup, &mut Random::new(0, Stream::Start));
        assert_eq!(given, Layout { start, ..drawn });
    }
}
