//! The parameters of this body.

use bica::prelude::*;
use bica_motion::model::{Profile, RobotModel};

use crate::Model;

/// Gait, kicks and odometry calibration of the body that the forward controls.
#[derive(Clone, Copy, Debug)]
pub struct RobotProfile {
    profile: &'static Profile,
}

#[component(budget_us = 1)]
impl RobotProfile {
    /// The profile of the built-in world.
    #[must_use]
    pub const fn new() -> Self {
        Self { profile: Model::KINEMATIC_PROFILE }
    }

    /// Sets the profile of another body.
    pub const fn set(&mut self, profile: &'static Profile) {
        self.profile = profile;
    }

    /// The profile.
    #[must_use]
    pub const fn get(&self) -> &'static Profile {
        self.profile
    }
}
