//! The parameters of this body.

use bica::prelude::*;
use bica_motion::model::{Profile, RobotModel};

use crate::MODEL;

/// Profile of a body.
#[derive(Clone, Copy, Debug, ParamEnum, PartialEq, Eq, serde::Serialize, postcard_schema::Schema)]
pub enum BodyProfile {
    /// The profile that the program has set.
    Program,
    /// Motions for a world without dynamics.
    Kinematic,
    /// Motions for a world with dynamics.
    Dynamic,
}

/// Choice of the profile.
#[derive(Params)]
pub struct ProfileChoice {
    /// Profile of the walk, the kicks and the odometry.
    #[param(default = BodyProfile::Program)]
    profile: BodyProfile,
}

/// Gait, kicks and odometry calibration of the body that the forward controls.
#[derive(Clone, Copy, Debug)]
pub struct RobotProfile {
    model: &'static RobotModel,
    /// Set by the program.
    set: &'static Profile,
    used: &'static Profile,
}

#[component(budget_us = 1)]
impl RobotProfile {
    /// The profile of the built-in world.
    #[must_use]
    pub const fn new() -> Self {
        Self::of(MODEL)
    }

    const fn of(model: &'static RobotModel) -> Self {
        Self { model, set: model.kinematic_profile, used: model.kinematic_profile }
    }

    fn step(&mut self, tuned: &Tuned<ProfileChoice>) {
        self.used = match tuned.profile {
            BodyProfile::Program => self.set,
            BodyProfile::Kinematic => self.model.kinematic_profile,
            BodyProfile::Dynamic => self.model.dynamic_profile,
        };
    }

    /// Sets the model of the controlled robot, see [`set_model`](crate::model::set_model).
    pub(crate) const fn set_model(&mut self, model: &'static RobotModel) {
        *self = Self::of(model);
    }

    /// Sets the profile of another body, for as long as the parameter `profile` is `Program`.
    pub const fn set(&mut self, profile: &'static Profile) {
        (self.set, self.used) = (profile, profile);
    }

    /// The profile.
    #[must_use]
    pub const fn get(&self) -> &'static Profile {
        self.used
    }

    /// The kind of the profile in use: that of a world with dynamics walks as a pendulum.
    #[output]
    fn used(&self) -> BodyProfile {
        if self.used.gait.pendulum_height > 0.0 { BodyProfile::Dynamic } else { BodyProfile::Kinematic }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn program_profile_is_used_unless_tuned() {
        let mut profile = RobotProfile::new();
        profile.set(MODEL.dynamic_profile);
        for (choice, used) in [
            (BodyProfile::Program, MODEL.dynamic_profile),
            (BodyProfile::Kinematic, MODEL.kinematic_profile),
            (BodyProfile::Program, MODEL.dynamic_profile),
        ] {
            profile.step(&Tuned::new(ProfileChoice { profile: choice }));
            assert_eq!(profile.get(), used, "{choice:?}");
        }
        assert_eq!(profile.used(), BodyProfile::Dynamic);
        assert_ne!(MODEL.dynamic_profile, MODEL.kinematic_profile);
    }
}
