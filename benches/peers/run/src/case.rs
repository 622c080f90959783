//! A design and a workload, with the subject's type erased.

use std::hint::black_box;
use std::time::Instant;

use peers::part::set_rounds;
use peers::report::figures::{Design, Workload};
use peers::subject::{CYCLE_US, Subject};

/// Design and workload that are measured together.
pub struct Case {
    /// The design.
    pub design: Design,
    /// The workload.
    pub workload: Workload,
    runner: Box<dyn Runner>,
}

impl Case {
    /// Creates a case from its subject.
    pub fn new(design: Design, workload: Workload, subject: impl Subject + 'static) -> Self {
        Self { design, workload, runner: Box::new(Running { subject, now: 0 }) }
    }

    /// Runs `cycles` cycles.
    pub fn run(&mut self, cycles: u64) {
        set_rounds(self.workload.rounds());
        self.runner.run(cycles);
    }

    /// Measures the mean time of a cycle over `cycles` cycles, ns.
    pub fn time(&mut self, cycles: u64) -> f64 {
        set_rounds(self.workload.rounds());
        let began = Instant::now();
        self.runner.run(cycles);
        began.elapsed().as_nanos() as f64 / cycles as f64
    }

    /// Result of the workload; valid only directly after a run.
    #[must_use]
    pub fn result(&self) -> u64 {
        self.runner.result()
    }
}

/// Loop over cycles, compiled for each subject, so that only the batch is a dynamic call.
trait Runner {
    fn run(&mut self, cycles: u64);
    fn result(&self) -> u64;
}

struct Running<S> {
    subject: S,
    now: u64,
}

impl<S: Subject> Runner for Running<S> {
    fn run(&mut self, cycles: u64) {
        for _ in 0..cycles {
            black_box(&mut self.subject).cycle(self.now);
            self.now += CYCLE_US;
        }
    }

    fn result(&self) -> u64 {
        self.subject.result()
    }
}
