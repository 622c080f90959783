//! What to build a field world from.

use bica_field::FIELD;
use core::fmt;

use bica_motion::pose::Pose2;
use glam::Vec2;

use crate::obstacle::{GOALS, Obstacle};

const BALL_RADIUS: f32 = FIELD.ball_radius();
const CARPET: Vec2 = FIELD.carpet_corner();

/// How near the robot's middle may come to anything, m.
pub(crate) const ROBOT_RADIUS: f32 = 0.15;

/// The most other robots that fit comfortably, the goalkeeper not counted.
pub const MAX_ROBOTS: usize = 8;

/// What to build a [`KinematicWorld`](crate::kinematic::KinematicWorld) from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// Decides everything that differs from game to game: start, goal colours, light, camera, noise.
    pub seed: u64,
    /// The size of camera images.
    pub frame: Frame,
    /// Whether a goalkeeper stands in the goal.
    pub goalkeeper: bool,
    /// How many more robots stand on the field, at most [`MAX_ROBOTS`].
    pub robots: usize,
    /// Where robot and ball are at first; by the seed if `None`.
    pub start: Option<Start>,
}

impl Default for Setup {
    fn default() -> Self {
        Self { seed: 0, frame: Frame::default(), goalkeeper: true, robots: 0, start: None }
    }
}

/// The size of camera images.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Frame {
    /// 160×120.
    Small,
    /// 320×240.
    #[default]
    Medium,
    /// 640×480.
    Large,
}

impl Frame {
    /// Width and height, pixels.
    #[must_use]
    pub const fn size(self) -> (usize, usize) {
        match self {
            Self::Small => (160, 120),
            Self::Medium => (320, 240),
            Self::Large => (640, 480),
        }
    }

    /// The frame of that many pixels; `None` if there is none.
    #[must_use]
    pub fn of_size(width: usize, height: usize) -> Option<Self> {
        [Self::Small, Self::Medium, Self::Large].into_iter().find(|frame| frame.size() == (width, height))
    }
}

/// Where robot and ball are at first. Field frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// The middle of the robot's torso, on the ground.
    pub robot: Pose2,
    /// The middle of the ball.
    pub ball: Vec2,
}

/// Why a [`Setup`] makes no world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SetupError {
    /// More robots than fit.
    TooManyRobots(usize),
    /// The robot's start is not on the carpet, or no number.
    RobotOffCarpet(Pose2),
    /// The ball's start is not on the carpet, or no number.
    BallOffCarpet(Vec2),
    /// The robot would stand in a goal's post or net.
    RobotInGoal(Pose2),
    /// The ball would lie in a goal's post or net.
    BallInGoal(Vec2),
    /// Robot and ball would be in the same place.
    BallUnderRobot(Vec2),
}

impl fmt::Display for SetupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooManyRobots(count) => {
                write!(f, "{count} more robots do not fit on the field: at most {MAX_ROBOTS} do")
            }
            Self::RobotOffCarpet(Pose2 { position: at, heading }) => write!(
                f,
                "the robot cannot start at ({}, {}) heading {heading}: the carpet reaches to x ±{} and y ±{} m",
                at.x, at.y, CARPET.x, CARPET.y
            ),
            Self::BallOffCarpet(at) => write!(
                f,
                "the ball cannot start at ({}, {}): the carpet reaches to x ±{} and y ±{} m",
                at.x, at.y, CARPET.x, CARPET.y
            ),
            Self::RobotInGoal(Pose2 { position: at, .. }) => {
                write!(f, "the robot cannot start at ({}, {}): a post or a net is there", at.x, at.y)
            }
            Self::BallInGoal(at) => {
                write!(f, "the ball cannot start at ({}, {}): a post or a net is there", at.x, at.y)
            }
            Self::BallUnderRobot(at) => write!(f, "the ball cannot start at ({}, {}): the robot is there", at.x, at.y),
        }
    }
}

impl core::error::Error for SetupError {}

impl Setup {
    /// # Errors
    ///
    /// If no world can be built from this; says why.
    pub(crate) fn check(&self) -> Result<(), SetupError> {
        if self.robots > MAX_ROBOTS {
            return Err(SetupError::TooManyRobots(self.robots));
        }
        self.start.map_or(Ok(()), |start| start.check())
    }
}

impl Start {
    fn check(&self) -> Result<(), SetupError> {
        if !on_carpet(self.robot.position) || !self.robot.heading.is_finite() {
            return Err(SetupError::RobotOffCarpet(self.robot));
        }
        if !on_carpet(self.ball) {
            return Err(SetupError::BallOffCarpet(self.ball));
        }
        let hits = |at, radius| move |obstacle: &Obstacle| obstacle.overlap(at, radius).is_some();
        if GOALS.iter().any(hits(self.robot.position, ROBOT_RADIUS)) {
            return Err(SetupError::RobotInGoal(self.robot));
        }
        if GOALS.iter().any(hits(self.ball, BALL_RADIUS)) {
            return Err(SetupError::BallInGoal(self.ball));
        }
        if self.robot.position.distance(self.ball) < ROBOT_RADIUS {
            return Err(SetupError::BallUnderRobot(self.ball));
        }
        Ok(())
    }
}

fn on_carpet(at: Vec2) -> bool {
    at.x.abs() <= CARPET.x && at.y.abs() <= CARPET.y
}

#[cfg(test)]
mod tests {
    use super::*;

    fn start(x: f32, y: f32, heading: f32, ball: Vec2) -> Result<(), SetupError> {
        let start = Some(Start { robot: Pose2::new(x, y, heading), ball });
        Setup { start, ..Setup::default() }.check()
    }

    #[test]
    fn a_bad_setup_is_refused_and_the_reason_named() {
        let ball = Vec2::new(1.0, 0.0);
        assert_eq!(start(0.0, 0.0, 0.0, ball), Ok(()));
        assert!(matches!(start(f32::NAN, 0.0, 0.0, ball), Err(SetupError::RobotOffCarpet(_))));
        assert!(matches!(start(0.0, 0.0, f32::INFINITY, ball), Err(SetupError::RobotOffCarpet(_))));
        assert!(matches!(start(0.0, 3.0, 0.0, ball), Err(SetupError::RobotOffCarpet(_))));
        assert!(matches!(start(3.0, 0.7, 0.0, ball), Err(SetupError::RobotInGoal(_))));
        assert!(matches!(start(0.0, 0.0, 0.0, Vec2::new(4.0, 0.0)), Err(SetupError::BallOffCarpet(_))));
        assert!(matches!(start(0.0, 0.0, 0.0, Vec2::new(3.05, 0.72)), Err(SetupError::BallInGoal(_))));
        assert!(matches!(start(1.0, 0.1, 0.0, ball), Err(SetupError::BallUnderRobot(_))));
        let error = Setup { robots: 9, ..Setup::default() }.check();
        assert_eq!(error, Err(SetupError::TooManyRobots(9)));
        assert!(SetupError::TooManyRobots(9).to_string().contains("at most 8"));
    }

    #[test]
    fn frames_are_known_by_their_size() {
        assert_eq!(Frame::of_size(640, 480), Some(Frame::Large));
        assert_eq!(Frame::of_size(641, 480), None);
    }
}
