//! Perception from directions and distances: one component for each stimulus.

mod ball_detector;
mod camera_pose;
mod field_boundary;
mod goal_detector;
mod localization;
mod robot_detector;

pub use ball_detector::{BallDetector, BallSighting, BallTracking};
pub use camera_pose::CameraPose;
pub use field_boundary::FieldBoundary;
pub use goal_detector::GoalDetector;
pub use localization::Localization;
pub use robot_detector::RobotDetector;
