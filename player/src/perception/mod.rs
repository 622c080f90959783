//! What the robot sees and feels, one component for each stimulus.

mod aim;
mod ball_detector;
mod camera_pose;
mod fall_detector;
mod field_boundary;
mod field_lines;
mod localization;
mod net_detector;
mod odometry;
mod own_body;
mod ride;
mod robot_detector;

pub use aim::Direction;
pub use ball_detector::{BallDetector, Seen};
pub use camera_pose::CameraPose;
pub use fall_detector::FallDetector;
pub use field_boundary::FieldBoundary;
pub use field_lines::FieldLines;
pub use localization::Localization;
pub use net_detector::NetDetector;
pub use odometry::Odometry;
pub use own_body::OwnBody;
pub use robot_detector::RobotDetector;
