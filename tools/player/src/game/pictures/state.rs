//! State of a game, for a picture.

use bica_field::GoalColour;
use bica_motion::pose::Pose2;
use glam::Vec2;

/// Estimates of the robot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimates {
    /// Pose on the field, m: odometry from the true start.
    pub robot: Pose2,
    /// Ball in the robot's frame, m.
    pub ball: Option<Vec2>,
    /// Centre of the attacked goal in the robot's frame, m.
    pub goal: Option<Vec2>,
}

/// True state of a game in the field frame, m.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundTruth {
    /// Colour of the goal at positive x, which the robot attacks.
    pub attacks: GoalColour,
    /// Pose of the robot.
    pub robot: Pose2,
    /// Position of the ball.
    pub ball: Vec2,
    /// Poses of the goalkeeper and other robots.
    pub others: Vec<Pose2>,
    /// Path of the ball so far.
    pub trail: Vec<Vec2>,
}
