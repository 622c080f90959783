//! The field boundary.

use bica::prelude::*;
use glam::Vec2;

use super::Localization;
use crate::league::FIELD;

/// The end of the field by the robot's pose.
#[derive(Debug)]
pub struct FieldBoundary {
    pose: Option<bica_motion::pose::Pose2>,
}

#[component(hz = 30, budget_us = 1)]
impl FieldBoundary {
    /// Creates the component with an unknown pose.
    #[must_use]
    pub const fn new() -> Self {
        Self { pose: None }
    }

    fn step(&mut self, field: &Localization) {
        self.pose = field.pose();
    }

    /// Whether a position in the ground frame between the feet, m, is on the carpet; without a pose, none is.
    #[must_use]
    pub fn is_on_field(&self, at: Vec2) -> bool {
        self.pose.is_some_and(|pose| pose.place(at).abs().cmple(FIELD.carpet_corner()).all())
    }
}
