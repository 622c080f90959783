//! The kicks.

use bica::prelude::*;
use bica_motion::kick::{Kick, KickMotion};

use crate::input::Measured;
use crate::output::Motors;

/// Plays a kick from stand to stand.
#[derive(Debug)]
pub struct Kicker {
    kick: Option<Kick>,
    motion: Option<KickMotion>,
}

#[component(budget_us = 15)]
impl Kicker {
    /// Has nothing to play.
    #[must_use]
    pub const fn new() -> Self {
        Self { kick: None, motion: None }
    }

    fn step(&mut self, time: &Time, body: &Measured, motors: &mut Motors) {
        if let Some(kick) = self.kick {
            let motion = self.motion.get_or_insert(KickMotion::new(kick, body.profile()));
            motors.limbs(&motion.step(&body.feedback(), time.dt()));
        }
    }

    #[stop]
    fn end(&mut self) {
        *self = Self::new();
    }

    /// Plays `kick`, unless one is being played.
    pub fn play(&mut self, kick: Kick) {
        self.kick.get_or_insert(kick);
    }

    /// Whether the kick is over and the robot stands again.
    #[must_use]
    pub fn done(&self) -> bool {
        self.motion.is_some_and(|motion| motion.is_done())
    }
}
