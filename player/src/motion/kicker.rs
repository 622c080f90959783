//! The kicks.

use bica::prelude::*;
use bica_motion::kick::{Kick, KickMotion};

use crate::Model;
use crate::input::{RobotProfile, RobotState};
use crate::output::Motors;

/// Plays a kick that begins and ends in the stand.
#[derive(Debug)]
pub struct Kicker {
    kick: Option<Kick>,
    motion: Option<KickMotion<Model>>,
}

#[component(budget_us = 15)]
impl Kicker {
    /// Creates the component without a kick.
    #[must_use]
    pub const fn new() -> Self {
        Self { kick: None, motion: None }
    }

    fn step(&mut self, time: &Time, state: &RobotState, profile: &RobotProfile, motors: &mut Motors) {
        if let Some(kick) = self.kick {
            let motion = self.motion.get_or_insert(KickMotion::new(kick, profile.get()));
            motors.set_limbs(&motion.step(&state.feedback(), time.dt()));
        }
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    /// Requests `kick`, unless another one was requested before.
    pub fn play(&mut self, kick: Kick) {
        self.kick.get_or_insert(kick);
    }

    /// Whether the kick is over and the robot stands again.
    #[must_use]
    pub fn done(&self) -> bool {
        self.motion.is_some_and(|motion| motion.is_done())
    }
}
