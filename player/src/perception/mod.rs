//! Perception: one component for each stimulus.

mod ball_detector;
mod bearing;
mod camera_pose;
pub(crate) mod ego_motion;
mod fall_detector;
mod field_boundary;
mod field_lines;
mod goal_detector;
mod localization;
mod odometry;
mod own_body;
mod robot_detector;

use bica::{Has, Tree};

pub use ball_detector::{BallDetector, BallSighting, BallTracking};
pub use bearing::Bearing;
pub use camera_pose::{CameraErrors, CameraMounting, CameraPose};
pub use fall_detector::{FallDetection, FallDetector};
pub use field_boundary::FieldBoundary;
pub use field_lines::FieldLines;
pub use goal_detector::{GoalDetector, GoalTracking};
pub use localization::Localization;
pub use odometry::{Odometry, OdometryCorrection};
pub use own_body::{OwnBody, OwnShape};
pub use robot_detector::{RobotDetector, RobotTracking};

/// Counts a cycle for what perception estimates. A robot calls it in each `sense`: what a component that does not run has estimated
/// becomes old, and readers do not get it any more.
pub fn pass_cycle<T>(tree: &mut T)
where
    T: Tree
        + Has<BallDetector>
        + Has<GoalDetector>
        + Has<RobotDetector>
        + Has<Localization>
        + Has<FieldLines>
        + Has<FieldBoundary>
        + Has<CameraPose>
        + Has<Odometry>,
{
    tree.get_mut::<BallDetector>().pass_cycle();
    tree.get_mut::<GoalDetector>().pass_cycle();
    tree.get_mut::<RobotDetector>().pass_cycle();
    tree.get_mut::<Localization>().pass_cycle();
    tree.get_mut::<FieldLines>().pass_cycle();
    tree.get_mut::<FieldBoundary>().pass_cycle();
    tree.get_mut::<CameraPose>().pass_cycle();
    tree.get_mut::<Odometry>().pass_cycle();
}
