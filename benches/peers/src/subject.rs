//! What is measured.

/// Microseconds between two cycles: a hundred cycles a second.
pub const CYCLE_US: u64 = 10_000;

/// Some work done some way.
pub trait Subject {
    /// One cycle at `now`, µs since the first, a multiple of [`CYCLE_US`].
    fn cycle(&mut self, now: u64);

    /// What the work came to; the same for all who do the same work.
    fn result(&self) -> u64;
}

/// The results after each of the first `cycles` cycles.
pub fn results(subject: &mut impl Subject, cycles: u64) -> Vec<u64> {
    let after = |cycle| {
        subject.cycle(cycle * CYCLE_US);
        subject.result()
    };
    (0..cycles).map(after).collect()
}

/// A whole program around a subject, to see how large it gets.
pub fn show(mut subject: impl Subject) {
    for cycle in 0..1000 {
        subject.cycle(cycle * CYCLE_US);
    }
    println!("{}", subject.result());
}
