//! The same trial with many seeds.

use bica_app::{Batch, Failure};
use bica_sim::mujoco::Physics;

use super::TrialOptions;

/// Seeds and physics of the trials.
pub(super) struct Series {
    batch: Batch,
    pub(super) physics: Physics,
}

impl Series {
    pub(super) fn new(options: &TrialOptions) -> Self {
        Self { batch: Batch::new(options.seed, options.runs, options.threads), physics: options.physics }
    }

    /// Number of seeds.
    pub(super) const fn runs(&self) -> u32 {
        self.batch.runs
    }

    /// Number of runs that must succeed, if `of_20` of 20 runs must succeed.
    pub(super) const fn needed(&self, of_20: u32) -> usize {
        (self.batch.runs as u64 * of_20 as u64).div_ceil(20) as usize
    }

    /// Returns the result of each seed, in the order of the seeds; fewer after Ctrl-C.
    pub(super) fn each<T: Send>(&self, trial: impl Fn(u64) -> Result<T, Failure> + Sync) -> Result<Vec<T>, Failure> {
        self.batch.run(trial)
    }
}
