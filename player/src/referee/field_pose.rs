//! The robot's pose on the field between sightings of marks.

use core::f32::consts::PI;

use bica::prelude::*;
use bica::visual;
use bica_field::GoalColour;
use bica_motion::pose::Pose2;
use bica_vision::localization::Estimate;
use glam::{Mat3, Vec3};

use crate::perception::{GoalDetector, Localization, Odometry};
use crate::shapes;

/// Standard deviation that the odometry adds for each metre, m and rad: a share of the way.
const WALKING_ERROR: f32 = 0.1;

/// The pose on the field: the localization's while it is certain, otherwise by odometry from the last certain pose.
#[derive(Debug)]
pub struct FieldPose {
    /// Origin of the odometry in the field frame; `None` before the first certain pose.
    origin: Option<Pose2>,
    pose: Option<Pose2>,
    /// Last certain pose, with its covariance.
    certain: Pose2,
    covariance: Mat3,
    attacked: GoalColour,
}

#[component(hz = 30, budget_us = 5)]
impl FieldPose {
    /// Creates the component without a pose.
    #[must_use]
    pub const fn new() -> Self {
        Self { origin: None, pose: None, certain: Pose2::ORIGIN, covariance: Mat3::ZERO, attacked: GoalColour::Yellow }
    }

    /// Creates the component at a pose, field frame.
    #[must_use]
    pub const fn at(pose: Pose2) -> Self {
        Self { origin: Some(pose), pose: Some(pose), certain: pose, ..Self::new() }
    }

    /// Sets the pose, field frame, of a robot whose start is known; its odometry begins there.
    pub const fn place(&mut self, pose: Pose2) {
        *self = Self { attacked: self.attacked, ..Self::at(pose) };
    }

    fn step(&mut self, field: &Localization, odometry: &Odometry, goal: &GoalDetector) {
        self.attacked = goal.attacked();
        if let Some(estimate) = field.estimate().filter(Estimate::is_sure) {
            self.origin = Some(estimate.pose * odometry.pose().inverse());
            (self.certain, self.covariance) = (estimate.pose, estimate.covariance);
        }
        self.pose = self.origin.map(|origin| origin * odometry.pose());
    }

    /// Forgets the pose: people have carried the robot.
    pub const fn forget(&mut self) {
        *self = Self { attacked: self.attacked, ..Self::new() };
    }

    /// Pose of the point on the ground between the feet, in the field frame; `None` before the first certain pose.
    #[must_use]
    pub const fn pose(&self) -> Option<Pose2> {
        self.pose
    }

    /// Covariance of the pose, x and y, m, and heading, rad: that of the last certain pose, with what the odometry adds on the way.
    #[must_use]
    pub fn covariance(&self) -> Mat3 {
        let way = self.pose.map_or(0.0, |pose| pose.position.distance(self.certain.position));
        let variance = (WALKING_ERROR * way) * (WALKING_ERROR * way);
        self.covariance + Mat3::from_diagonal(Vec3::splat(variance))
    }

    /// Place of the field frame of the own team in a frame of both teams, with x towards the yellow goal.
    #[output(frame = "pitch", child = "field")]
    fn field_place(&self) -> visual::Pose2 {
        visual::Pose2 { x: 0.0, y: 0.0, heading: if self.attacked == GoalColour::Yellow { 0.0 } else { PI } }
    }

    /// Pose in the field frame: x towards the attacked goal, from the centre.
    #[output(frame = "field")]
    fn field_pose(&self) -> Option<visual::Pose2> {
        self.pose.map(shapes::pose)
    }
}
