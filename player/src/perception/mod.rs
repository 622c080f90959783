//! Perception: one component for each stimulus.

mod ball_detector;
mod bearing;
mod camera_pose;
mod ego_motion;
mod fall_detector;
mod field_boundary;
mod field_lines;
mod goal_detector;
mod localization;
mod odometry;
mod own_body;
mod robot_detector;

pub use ball_detector::{BallDetector, BallSighting};
pub use bearing::Bearing;
pub use camera_pose::CameraPose;
pub use fall_detector::FallDetector;
pub use field_boundary::FieldBoundary;
pub use field_lines::FieldLines;
pub use goal_detector::GoalDetector;
pub use localization::Localization;
pub use odometry::Odometry;
pub use own_body::OwnBody;
pub use robot_detector::RobotDetector;
