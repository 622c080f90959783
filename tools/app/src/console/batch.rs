//! The same run with many seeds, on several threads.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::thread::{self, Builder};

use bica::runner::STACK_BYTES;

use super::{Failure, interrupt};

/// Runs with consecutive seeds.
#[derive(Clone, Copy, Debug)]
pub struct Batch {
    /// First seed; the successor of the largest `u64` is 0.
    pub first_seed: u64,
    /// Number of seeds.
    pub runs: u32,
    /// Number of threads.
    pub threads: usize,
}

impl Batch {
    /// Creates a batch. The default number of threads is the number of cores; there are never more threads than runs.
    #[must_use]
    pub fn new(first_seed: u64, runs: u32, threads: Option<u32>) -> Self {
        let cores = thread::available_parallelism().map_or(1, NonZero::get);
        let threads = threads.map_or(cores, |threads| threads as usize).min(runs as usize);
        Self { first_seed, runs, threads }
    }

    /// Returns the result of each seed, in the order of the seeds. After Ctrl-C no further run is started, so results may
    /// be missing.
    ///
    /// # Errors
    /// The error of a run, or that no thread can be started.
    pub fn run<T: Send>(&self, job: impl Fn(u64) -> Result<T, Failure> + Sync) -> Result<Vec<T>, Failure> {
        let next = AtomicU64::new(0);
        let end = || next.store(self.runs.into(), Relaxed);
        // Runs differ in length, so each thread takes the next run when it has finished one.
        let work = || {
            let take =
                || Some(next.fetch_add(1, Relaxed)).filter(|run| *run < self.runs.into() && !interrupt::requested());
            std::iter::from_fn(take)
                .map(|run| Ok((run, job(self.first_seed.wrapping_add(run)).inspect_err(|_| end())?)))
                .collect::<Result<Vec<_>, Failure>>()
        };
        let results = thread::scope(|scope| {
            let start = |_| Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, work).inspect_err(|_| end());
            let threads: Vec<_> = (0..self.threads).map(start).collect();
            let joined = threads.into_iter().map(|thread| {
                let thread = thread
                    .map_err(|error| Failure::new(format!("cannot start a thread: {error}"), "try fewer --threads"))?;
                thread.join().unwrap_or_else(|panic| resume_unwind(panic))
            });
            joined.collect::<Result<Vec<_>, Failure>>()
        })?;
        let mut results: Vec<_> = results.into_iter().flatten().collect();
        results.sort_by_key(|(run, _)| *run);
        Ok(results.into_iter().map(|(_, result)| result).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_order_of_seeds() {
        for threads in [1, 2, 7, 40] {
            let batch = Batch::new(u64::MAX, 20, Some(threads));
            let seeds = batch.run(Ok).expect("no run fails");
            assert_eq!(seeds[0], u64::MAX);
            assert!(seeds[1..].iter().copied().eq(0..19), "{seeds:?}");
        }
    }

    #[test]
    fn error_of_run_ends_batch() {
        let run = |seed| if seed == 3 { Err(Failure::new("seed 3", "")) } else { Ok(seed) };
        let result = Batch::new(0, 8, Some(2)).run(run);
        assert!(matches!(result, Err(Failure::Error { what, .. }) if what == "seed 3"));
    }

    #[test]
    #[expect(clippy::large_stack_arrays, reason = "the stack of a run is under test")]
    fn stack_holds_a_large_tree() {
        let deep = |_| {
            let room = [1_u8; 16 << 20];
            Ok(std::hint::black_box(&room).iter().map(|&byte| usize::from(byte)).sum::<usize>())
        };
        assert_eq!(Batch::new(0, 1, None).run(deep).expect("no run fails"), [16 << 20]);
    }
}
