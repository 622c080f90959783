//! Subjects of the measurement.

/// Period of the cycles, µs: 100 cycles per second.
pub const CYCLE_US: u64 = 10_000;

/// Implementation of a workload.
pub trait Subject {
    /// Runs one cycle at `now`, µs since the first one, a multiple of [`CYCLE_US`].
    fn cycle(&mut self, now: u64);

    /// Result of the workload, equal for all designs.
    fn result(&self) -> u64;
}

/// Complete program around a subject, for the measurement of its size.
pub fn show(mut subject: impl Subject) {
    for cycle in 0..1000 {
        subject.cycle(cycle * CYCLE_US);
    }
    println!("{}", subject.result());
}
