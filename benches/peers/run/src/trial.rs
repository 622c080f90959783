//! One way to do one work, whose type is forgotten.

use std::hint::black_box;
use std::time::Instant;

use peers::report::figures::{Way, Work};
use peers::subject::{CYCLE_US, Subject};

/// One way to do one work.
pub struct Trial {
    /// The way.
    pub way: Way,
    /// The work.
    pub work: Work,
    runner: Box<dyn Runner>,
}

impl Trial {
    /// That way to do that work, at rest.
    pub fn new(way: Way, work: Work, subject: impl Subject + 'static) -> Self {
        Self { way, work, runner: Box::new(Running { subject, now: 0 }) }
    }

    /// Does so many cycles.
    pub fn run(&mut self, cycles: u64) {
        self.runner.run(cycles);
    }

    /// What one of so many cycles takes, ns.
    pub fn time(&mut self, cycles: u64) -> f64 {
        let began = Instant::now();
        self.runner.run(cycles);
        began.elapsed().as_nanos() as f64 / cycles as f64
    }

    /// What the work came to; ask right after a run.
    #[must_use]
    pub fn result(&self) -> u64 {
        self.runner.result()
    }
}

/// The loop around the cycles is made for each subject, so that nothing stands between the two.
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
