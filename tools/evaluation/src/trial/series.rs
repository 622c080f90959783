//! The same trial with many seeds.

use bica_app::{Batch, Failure};
use bica_body::random::Random;
use bica_motion::model::simulation::SimulatedModel;
use bica_sim::mujoco::Physics;

use super::course::Course;
use crate::trial_options::TrialOptions;

/// Seeds and physics of the trials.
pub(super) struct Series {
    pub(super) model: &'static SimulatedModel,
    pub(super) course: &'static Course,
    batch: Batch,
    pub(super) physics: Physics,
}

impl Series {
    pub(super) fn new(model: &'static SimulatedModel, options: &TrialOptions) -> Self {
        let default = Physics { cameras: false, ..Physics::of(model) };
        let physics = Physics {
            friction: options.friction.unwrap_or(default.friction),
            leg_gain: options.leg_gain.unwrap_or(default.leg_gain),
            torque_limit: options.torque_limit.unwrap_or(default.torque_limit),
            dead_time: options.dead_time.unwrap_or(default.dead_time),
            noise: options.noise.unwrap_or(default.noise),
            ..default
        };
        Self {
            model,
            course: Course::of(model),
            batch: Batch::new(options.seed, options.runs, options.threads),
            physics,
        }
    }

    /// Number of seeds.
    pub(super) const fn runs(&self) -> u32 {
        self.batch.runs
    }

    /// Number of runs that must succeed if `of_20` of 20 runs must succeed.
    pub(super) const fn needed(&self, of_20: u32) -> usize {
        (self.batch.runs as u64 * of_20 as u64).div_ceil(20) as usize
    }

    /// Runs a trial for each seed; returns the results in the order of the seeds, fewer after Ctrl-C.
    pub(super) fn each<T: Send>(&self, trial: impl Fn(u64) -> Result<T, Failure> + Sync) -> Result<Vec<T>, Failure> {
        self.batch.run(trial)
    }
}

/// Returns the random numbers of a run.
pub(super) fn random(seed: u64) -> Random {
    Random::new(seed, 0x7472_6961_6c73_u64)
}
