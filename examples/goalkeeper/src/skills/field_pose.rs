//! The robot's pose on the field.

use bica::prelude::*;
use bica::visual;
use bica_motion::pose::Pose2;
use bica_player::perception::{Localization, Odometry};
use bica_player::shapes;

/// Pose in the field frame, in which the robot starts: in the middle of its goal, facing the field.
pub const START: Pose2 = Pose2::new(-2.95, 0.0, 0.0);

/// The robot's pose on the field: the localization's pose while it is certain, otherwise odometry from the last certain pose.
#[derive(Debug)]
pub struct FieldPose {
    /// Origin of the odometry in the field frame.
    origin: Pose2,
    pose: Pose2,
}

#[component(hz = 30, budget_us = 5)]
impl FieldPose {
    /// Creates the component with the robot at its start.
    #[must_use]
    pub const fn new() -> Self {
        Self { origin: START, pose: START }
    }

    fn step(&mut self, field: &Localization, odometry: &Odometry) {
        if let Some(pose) = field.pose() {
            self.origin = pose * odometry.pose().inverse();
        }
        self.pose = self.origin * odometry.pose();
    }

    /// Pose of the point on the ground between the feet, in the field frame: x towards the other goal, from the centre.
    #[must_use]
    pub const fn pose(&self) -> Pose2 {
        self.pose
    }

    /// Pose in the field frame.
    #[output(frame = "field")]
    fn field_pose(&self) -> visual::Pose2 {
        shapes::pose(self.pose)
    }
}
