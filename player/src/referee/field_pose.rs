//! The robot's pose on the field between sightings of marks.

use bica::prelude::*;
use bica::visual;
use bica_motion::pose::Pose2;

use crate::info;
use crate::perception::{Localization, Odometry};

/// The pose on the field: the localization's while it is certain, otherwise by odometry from the last certain pose.
#[derive(Debug)]
pub struct FieldPose {
    /// Origin of the odometry in the field frame; `None` before the first certain pose.
    origin: Option<Pose2>,
    pose: Option<Pose2>,
}

#[component(hz = 30, budget_us = 5)]
impl FieldPose {
    /// Creates the component without a pose.
    #[must_use]
    pub const fn new() -> Self {
        Self { origin: None, pose: None }
    }

    /// Creates the component at a pose, field frame.
    #[must_use]
    pub const fn at(pose: Pose2) -> Self {
        Self { origin: Some(pose), pose: Some(pose) }
    }

    fn step(&mut self, field: &Localization, odometry: &Odometry) {
        if let Some(pose) = field.pose() {
            self.origin = Some(pose * odometry.pose().inverse());
        }
        self.pose = self.origin.map(|origin| origin * odometry.pose());
    }

    /// Forgets the pose: people have carried the robot.
    pub const fn forget(&mut self) {
        *self = Self::new();
    }

    /// Pose of the point on the ground between the feet, in the field frame; `None` before the first certain pose.
    #[must_use]
    pub const fn pose(&self) -> Option<Pose2> {
        self.pose
    }

    /// Pose in the field frame: x towards the attacked goal, from the centre.
    #[info(frame = "field")]
    fn field_pose(&self) -> Option<visual::Pose2> {
        self.pose.map(info::pose)
    }
}
