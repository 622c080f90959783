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

use bica::{Has, Tree};

pub use ball_detector::{BallDetector, BallSighting, BallTracking};
pub use bearing::Bearing;
pub use camera_pose::CameraPose;
pub use fall_detector::{FallDetection, FallDetector};
pub use field_boundary::FieldBoundary;
pub use goal_detector::GoalDetector;
pub use localization::Localization;
pub use odometry::{Odometry, OdometryCorrection};
pub use robot_detector::RobotDetector;

/// Counts a cycle for what perception estimates. A robot calls it in each `sense`: what a component that does not run has estimated
/// becomes old, and readers do not get it any more.
pub fn pass_cycle<T>(tree: &mut T)
where
    T: Tree
        + Has<BallDetector>
        + Has<GoalDetector>
        + Has<RobotDetector>
        + Has<Localization>
        + Has<CameraPose>
        + Has<Odometry>,
{
    tree.get_mut::<BallDetector>().pass_cycle();
    tree.get_mut::<GoalDetector>().pass_cycle();
    tree.get_mut::<RobotDetector>().pass_cycle();
    tree.get_mut::<Localization>().pass_cycle();
    tree.get_mut::<CameraPose>().pass_cycle();
    tree.get_mut::<Odometry>().pass_cycle();
}
