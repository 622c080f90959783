//! A design and a workload, with the subject's type erased.

use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Instant;

use crate::part::{combine, set_rounds};
use crate::subject::{CYCLE_US, Subject};

/// Design and workload that are measured together.
pub struct Case {
    /// The design.
    pub design: &'static str,
    /// The workload. All designs with the same one compute the same results.
    pub workload: &'static str,
    runner: Box<dyn Runner>,
}

impl Case {
    /// Creates a case with empty steps, or with steps of about 20 ns.
    pub fn new<const SIZED: bool>(
        design: &'static str,
        workload: &'static str,
        subject: impl Subject + 'static,
    ) -> Self {
        Self { design, workload, runner: Box::new(Running::<_, SIZED> { subject, now: 0 }) }
    }

    /// Runs `cycles` cycles.
    pub fn run(&mut self, cycles: u64) {
        self.runner.run(cycles);
    }

    /// Measures the mean time of a cycle over `cycles` cycles, ns.
    pub fn time(&mut self, cycles: u64) -> f64 {
        let began = Instant::now();
        self.run(cycles);
        began.elapsed().as_nanos() as f64 / cycles as f64
    }
}

/// Mixes the results of the first `cycles` cycles of new cases, for each workload.
///
/// # Errors
/// If two designs compute different results.
pub fn compare(cases: &mut [Case], cycles: u64) -> Result<BTreeMap<&'static str, u64>, String> {
    let mut results = BTreeMap::new();
    for Case { design, workload, runner } in cases {
        let result = (0..cycles).fold(0, |sum, _| {
            runner.run(1);
            combine(sum, [runner.result()])
        });
        let &mut (other, expected) = results.entry(*workload).or_insert((*design, result));
        if result != expected {
            return Err(format!("{workload}: {design} computes {result}, {other} computes {expected}"));
        }
    }
    Ok(results.into_iter().map(|(workload, (_, result))| (workload, result)).collect())
}

/// Loop over cycles, compiled for each subject, so that only the batch is a dynamic call.
trait Runner {
    fn run(&mut self, cycles: u64);

    /// Result of the workload; valid only directly after a run.
    fn result(&self) -> u64;
}

struct Running<S, const SIZED: bool> {
    subject: S,
    now: u64,
}

impl<S: Subject, const SIZED: bool> Runner for Running<S, SIZED> {
    fn run(&mut self, cycles: u64) {
        set_rounds(if SIZED { 24 } else { 0 });
        for _ in 0..cycles {
            black_box(&mut self.subject).cycle(self.now);
            self.now += CYCLE_US;
        }
    }

    fn result(&self) -> u64 {
        self.subject.result()
    }
}
