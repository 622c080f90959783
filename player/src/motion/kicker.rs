//! The kicks.

use bica::prelude::*;
use bica_motion::kick::{Kick, KickMotion};

use super::{KickChoice, SideChoice};
use crate::input::{RobotProfile, RobotState};
use crate::output::Motors;

/// Adjustment of the kicks of the robot's profile.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct KickTuning {
    /// Speed of the whole motion, except the strike, relative to the profile. Higher values are quicker and less stable.
    #[param(default = 1.0, range = 0.5..=1.3, step = 0.05)]
    pub speed_scale: f32,
    /// Speed of the strike, in which the foot hits the ball, relative to the profile. Higher values kick harder.
    #[param(default = 1.0, range = 0.3..=1.5, step = 0.05)]
    pub strike_speed_scale: f32,
    /// Additional forward lean of the torso. It should equal `Walk.torso_lean`: a kick begins and ends in the stand.
    #[param(default = 0.0, range = -0.1..=0.1, unit = "rad", step = 0.005)]
    pub torso_lean: f32,
}

/// Plays a kick that begins and ends in the stand.
#[derive(Debug)]
pub struct Kicker {
    kick: Option<Kick>,
    motion: Option<KickMotion>,
}

#[component(budget_us = 15)]
impl Kicker {
    /// Creates the component without a kick.
    #[must_use]
    pub const fn new() -> Self {
        Self { kick: None, motion: None }
    }

    fn step(
        &mut self,
        tuned: &Tuned<KickTuning>,
        time: &Time,
        state: &RobotState,
        profile: &RobotProfile,
        motors: &mut Motors,
    ) {
        if let Some(kick) = self.kick {
            let motion = self.motion.get_or_insert(KickMotion::new(state.model(), kick, profile.get()));
            let scale = if motion.strikes() { tuned.strike_speed_scale } else { tuned.speed_scale };
            let mut limbs = motion.step(&state.feedback(), time.dt() * scale);
            limbs.lean(tuned.torso_lean);
            motors.set_limbs(&limbs);
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

    /// Plays a kick, from the stand; another one may follow when it is over. Has no effect during a kick.
    #[modulation]
    pub fn kick(
        &mut self,
        /// Direction of the ball.
        direction: KickChoice,
        /// Kicking foot.
        foot: SideChoice,
    ) {
        if self.kick.is_none() || self.done() {
            *self = Self { kick: Some(direction.with(foot)), motion: None };
        }
    }

    /// The requested kick.
    #[output]
    #[must_use]
    pub const fn requested(&self) -> Option<Kick> {
        self.kick
    }

    /// Whether the foot moves through the position of the ball now.
    #[output]
    #[must_use]
    pub fn strikes(&self) -> bool {
        self.motion.is_some_and(|motion| motion.strikes())
    }

    /// Whether the kick is over and the robot stands again.
    #[output]
    #[must_use]
    pub fn done(&self) -> bool {
        self.motion.is_some_and(|motion| motion.is_done())
    }
}
