//! State of a game, for a picture.

use bica::Tree;
use bica_evaluation::pictures::Marks;
use bica_field::GoalColour;
use bica_motion::pose::Pose2;
use bica_motion::robot::Image;
use bica_player::input::CameraInput;
use bica_player::perception::{BallDetector, FieldBoundary, GoalDetector, Odometry, OwnBody};
use glam::Vec2;

use crate::game::scene::Scene;

/// Estimates of the robot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Estimates {
    /// Pose on the field, m: the true start plus odometry.
    pub(crate) robot: Pose2,
    /// Ball in the robot's frame, m.
    pub(crate) ball: Option<Vec2>,
    /// Centre of the attacked goal in the robot's frame, m.
    pub(crate) goal: Option<Vec2>,
}

/// True state of a game in the field frame, m.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct GroundTruth {
    /// Colour of the goal at positive x, which the robot attacks.
    pub(crate) attacks: GoalColour,
    /// Pose of the robot.
    pub(crate) robot: Pose2,
    /// Position of the ball.
    pub(crate) ball: Vec2,
    /// Poses of the goalkeeper and other robots.
    pub(crate) others: Vec<Pose2>,
    /// Path of the ball so far.
    pub(crate) trail: Vec<Vec2>,
}

impl Scene<'_> {
    /// Returns the detections of the active detectors in the newest image.
    pub(crate) fn marks(&self) -> Marks {
        let ball = self.robot.get::<BallDetector>().seen().filter(|_| self.is_active::<BallDetector>());
        let net = self.robot.get::<GoalDetector>().seen().filter(|_| self.is_active::<GoalDetector>());
        let end = Some(self.robot.get::<FieldBoundary>().line()).filter(|_| self.is_active::<FieldBoundary>());
        Marks {
            ball: ball.map(|seen| seen.ball),
            goals: net.copied().into_iter().collect(),
            field_boundary: end.map_or(Vec::new(), |line| line.corners().to_vec()),
            own: self.robot.get::<OwnBody>().body().clone(),
            ..Marks::default()
        }
    }

    /// Returns the estimates of the forward.
    pub(crate) fn estimates(&self) -> Estimates {
        Estimates {
            robot: self.start * self.robot.get::<Odometry>().pose(),
            ball: self.robot.get::<BallDetector>().position(),
            goal: self.robot.get::<GoalDetector>().position(),
        }
    }

    /// Returns the true state.
    pub(crate) fn truth(&self) -> GroundTruth {
        GroundTruth {
            attacks: self.referee.attacks(),
            robot: self.referee.robot(),
            ball: self.referee.ball(),
            others: self.referee.others().to_vec(),
            trail: self.ball_path.to_vec(),
        }
    }

    /// Returns the newest image; `None` before the first one.
    pub(crate) fn image(&self) -> Option<Image<'_>> {
        Some(self.robot.get::<CameraInput>().image()).filter(|image| image.width > 0)
    }
}
