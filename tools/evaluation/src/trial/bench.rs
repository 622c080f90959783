//! The same trial with many seeds, on all cores.

use std::num::NonZero;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use bica_sim::mujoco::Physics;

use super::Trial;

use bica_console::Failure;
use bica_console::{STACK, interrupt};

/// How often and with what a trial is made.
pub struct Bench {
    pub runs: u64,
    first: u64,
    threads: usize,
    pub physics: Physics,
}

impl Bench {
    /// One thread for each core, if nothing else is said.
    pub fn new(args: &Trial) -> Self {
        let cores = thread::available_parallelism().map_or(1, NonZero::get);
        let threads = args.threads.map_or(cores, |threads| threads as usize);
        Self { runs: args.runs.into(), first: args.seed, threads, physics: args.physics }
    }

    /// How many of the runs are needed where `wanted` of 20 are.
    pub const fn needed(&self, wanted: u64) -> usize {
        (self.runs * wanted).div_ceil(20) as usize
    }

    /// What came of each seed, in the order of the seeds; fewer if someone pressed Ctrl-C.
    pub fn each<T: Send>(&self, trial: impl Fn(u64) -> Result<T, Failure> + Sync) -> Result<Vec<T>, Failure> {
        let (next, done) = (AtomicU64::new(0), Mutex::new(Vec::new()));
        let work = || {
            while !interrupt::requested() {
                let run = next.fetch_add(1, Ordering::Relaxed);
                if run >= self.runs {
                    return;
                }
                let result = trial(self.first.wrapping_add(run));
                if let Ok(mut done) = done.lock() {
                    done.push((run, result));
                }
            }
        };
        thread::scope(|scope| {
            for _ in 0..self.threads.min(self.runs as usize) {
                let spawned = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
                spawned
                    .map_err(|error| Failure::new(format!("cannot start a thread: {error}"), "try fewer --threads"))?;
            }
            Ok::<(), Failure>(())
        })?;
        let mut done = done.into_inner().unwrap_or_default();
        done.sort_by_key(|(run, _)| *run);
        done.into_iter().map(|(_, result)| result).collect()
    }
}
