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

pub use ball_detector::{BallDetection, BallDetector, BallSighting, BallTracking};
pub use bearing::Bearing;
pub use camera_pose::{CameraErrors, CameraMounting, CameraPose};
pub use fall_detector::{FallDetection, FallDetector};
pub use field_boundary::{BoundaryDetection, FieldBoundary};
pub use field_lines::{FieldLines, LineDetection, MarkingDetection};
pub use goal_detector::{GoalDetection, GoalDetector, GoalTracking};
pub use localization::{Localization, MotionNoise, SightingUse};
pub use odometry::{Odometry, OdometryCorrection};
pub use own_body::{OwnBody, OwnShape};
pub use robot_detector::{RobotDetection, RobotDetector, RobotTracking};
