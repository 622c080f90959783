//! Perception: one component for each stimulus, under the names that the behaviours use.

mod ball_detector;
#[path = "../../../src/perception/bearing.rs"]
mod bearing;
mod camera_pose;
#[path = "../../../src/perception/ego_motion.rs"]
mod ego_motion;
#[path = "../../../src/perception/fall_detector.rs"]
mod fall_detector;
mod field_boundary;
mod goal_detector;
mod localization;
#[path = "../../../src/perception/odometry.rs"]
mod odometry;
mod robot_detector;

pub use ball_detector::{BallDetector, BallSighting, BallTracking};
pub use bearing::Bearing;
pub use camera_pose::CameraPose;
pub use fall_detector::{FallDetection, FallDetector};
pub use field_boundary::FieldBoundary;
pub use goal_detector::GoalDetector;
pub use localization::Localization;
pub use odometry::{Odometry, OdometryCorrection};
pub use robot_detector::RobotDetector;
