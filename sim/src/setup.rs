//! Parameters of a game: seed, image size, robots and start positions.

use core::fmt;
use core::str::FromStr;

use bica_field::GoalColour;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use glam::{Vec2, Vec3};

use crate::field::{BALL_RADIUS, CARPET};
use crate::obstacle::{GOALS, Obstacle};

/// Maximum number of other robots, not counting the goalkeeper.
pub const MAX_ROBOTS: usize = 8;

/// Parameters of a game, for either simulator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// Seed of everything that differs between games: start positions, goal colours, light, camera settings, noise.
    pub seed: u64,
    /// Size of camera images.
    pub frame: Frame,
    /// Whether a goalkeeper stands in the attacked goal.
    pub goalkeeper: bool,
    /// Number of further robots on the field, at most [`MAX_ROBOTS`]. They stand still.
    pub robots: usize,
    /// Start positions of robot and ball; drawn from the seed if `None`.
    pub start: Option<Start>,
    /// Colour of the goal that the robot attacks; drawn from the seed if `None`.
    pub attacks: Option<GoalColour>,
    /// Error of the mounting of both cameras in the head, rad: roll to the right, tilt downwards, pan to the left. Only the built-in
    /// world has it.
    pub mounting: Vec3,
}

impl Default for Setup {
    fn default() -> Self {
        Self {
            seed: 0,
            frame: Frame::default(),
            goalkeeper: true,
            robots: 0,
            start: None,
            attacks: None,
            mounting: Vec3::ZERO,
        }
    }
}

/// Size of camera images.
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
    /// Returns width and height, pixels.
    #[must_use]
    pub const fn size(self) -> (usize, usize) {
        match self {
            Self::Small => (160, 120),
            Self::Medium => (320, 240),
            Self::Large => (640, 480),
        }
    }

    /// Returns the variant with this size in pixels, if there is one.
    #[must_use]
    pub fn of_size(width: usize, height: usize) -> Option<Self> {
        [Self::Small, Self::Medium, Self::Large].into_iter().find(|frame| frame.size() == (width, height))
    }
}

impl FromStr for Frame {
    type Err = UnknownFrame;

    /// Parses `WIDTHxHEIGHT`, for example `320x240`.
    fn from_str(text: &str) -> Result<Self, UnknownFrame> {
        let known = text.split_once('x').and_then(|(width, height)| {
            let (width, height) = (width.parse().ok()?, height.parse().ok()?);
            Self::of_size(width, height)
        });
        known.ok_or(UnknownFrame)
    }
}

/// Error: the text does not name a [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownFrame;

impl fmt::Display for UnknownFrame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("give 160x120, 320x240 or 640x480")
    }
}

impl core::error::Error for UnknownFrame {}

/// Start positions of robot and ball. Field frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// Pose of the robot frame, projected to the ground.
    pub robot: Pose2,
    /// Centre of the ball, m.
    pub ball: Vec2,
}

/// The reason why a [`Setup`] is invalid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SetupError {
    /// More robots than [`MAX_ROBOTS`].
    TooManyRobots(usize),
    /// The robot's start pose is not on the carpet or not finite.
    RobotOffCarpet(Pose2),
    /// The ball's start position is not on the carpet or not finite.
    BallOffCarpet(Vec2),
    /// The robot would overlap a goal post or a net.
    RobotInGoal(Pose2),
    /// The ball would overlap a goal post or a net.
    BallInGoal(Vec2),
    /// Robot and ball would overlap.
    BallUnderRobot(Vec2),
    /// The velocity of the ball is not finite.
    BallVelocity(Vec2),
}

impl fmt::Display for SetupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooManyRobots(count) => {
                write!(f, "{count} other robots do not fit on the field: at most {MAX_ROBOTS} are possible")
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
            Self::BallVelocity(velocity) => {
                write!(f, "the ball cannot roll at ({}, {}) m/s: give finite numbers", velocity.x, velocity.y)
            }
        }
    }
}

impl core::error::Error for SetupError {}

impl Setup {
    /// Checks that a world can be built from these parameters.
    ///
    /// # Errors
    ///
    /// If a parameter is invalid; the error names it.
    pub(crate) fn check(&self, model: &'static SimulatedModel) -> Result<(), SetupError> {
        if self.robots > MAX_ROBOTS {
            return Err(SetupError::TooManyRobots(self.robots));
        }
        self.start.map_or(Ok(()), |start| start.check(model))
    }
}

impl Start {
    fn check(&self, model: &'static SimulatedModel) -> Result<(), SetupError> {
        if !on_carpet(self.robot.position) || !self.robot.heading.is_finite() {
            return Err(SetupError::RobotOffCarpet(self.robot));
        }
        let hits = |obstacle: &Obstacle| obstacle.overlap(self.robot.position, model.extents.standing).is_some();
        if GOALS.iter().any(hits) {
            return Err(SetupError::RobotInGoal(self.robot));
        }
        check_ball(model, self.ball, Vec2::ZERO, self.robot)
    }
}

/// Checks that a ball can be at a position, m, with a velocity, m/s, beside the robot. Field frame.
pub(crate) fn check_ball(
    model: &'static SimulatedModel,
    ball: Vec2,
    velocity: Vec2,
    robot: Pose2,
) -> Result<(), SetupError> {
    if !on_carpet(ball) {
        return Err(SetupError::BallOffCarpet(ball));
    }
    if GOALS.iter().any(|obstacle| obstacle.overlap(ball, BALL_RADIUS).is_some()) {
        return Err(SetupError::BallInGoal(ball));
    }
    if robot.position.distance(ball) < model.extents.standing {
        return Err(SetupError::BallUnderRobot(ball));
    }
    if velocity.is_finite() { Ok(()) } else { Err(SetupError::BallVelocity(velocity)) }
}

fn on_carpet(at: Vec2) -> bool {
    at.x.abs() <= CARPET.x && at.y.abs() <= CARPET.y
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;

    fn start(x: f32, y: f32, heading: f32, ball: Vec2) -> Result<(), SetupError> {
        let start = Some(Start { robot: Pose2::new(x, y, heading), ball });
        Setup { start, ..Setup::default() }.check(TEST_MODEL)
    }

    #[test]
    fn invalid_setup_is_rejected_with_its_reason() {
        let ball = Vec2::new(1.0, 0.0);
        assert_eq!(start(0.0, 0.0, 0.0, ball), Ok(()));
        assert!(matches!(start(f32::NAN, 0.0, 0.0, ball), Err(SetupError::RobotOffCarpet(_))));
        assert!(matches!(start(0.0, 0.0, f32::INFINITY, ball), Err(SetupError::RobotOffCarpet(_))));
        assert!(matches!(start(0.0, 3.0, 0.0, ball), Err(SetupError::RobotOffCarpet(_))));
        assert!(matches!(start(3.0, 0.7, 0.0, ball), Err(SetupError::RobotInGoal(_))));
        assert!(matches!(start(0.0, 0.0, 0.0, Vec2::new(4.0, 0.0)), Err(SetupError::BallOffCarpet(_))));
        assert!(matches!(start(0.0, 0.0, 0.0, Vec2::new(3.05, 0.72)), Err(SetupError::BallInGoal(_))));
        assert!(matches!(start(1.0, 0.1, 0.0, ball), Err(SetupError::BallUnderRobot(_))));
        let error = Setup { robots: 9, ..Setup::default() }.check(TEST_MODEL);
        assert_eq!(error, Err(SetupError::TooManyRobots(9)));
        assert!(SetupError::TooManyRobots(9).to_string().contains("at most 8"));
    }

    #[test]
    fn frame_is_found_by_its_size() {
        assert_eq!(Frame::of_size(640, 480), Some(Frame::Large));
        assert_eq!(Frame::of_size(641, 480), None);
        assert_eq!("320x240".parse(), Ok(Frame::Medium));
        for wrong in ["", "320", "320x", "320x241", "x", "-320x240", "320 x240"] {
            assert_eq!(wrong.parse::<Frame>(), Err(UnknownFrame), "`{wrong}`");
        }
    }
}
