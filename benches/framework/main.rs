//! Cost of the framework: visits, runs and state machines, each compared with the same work written by hand.
//!
//! `cargo bench -p bica-benches --bench framework` prints the minimum times of small and large trees, then Criterion's
//! figures. `cargo bench -p bica-benches --bench framework -- table` prints the minimum times alone. Figures of one run
//! may be compared with each other, never with figures of another machine.

mod active;
mod chain;
mod machine;
mod minima;
mod ticks;

use criterion::Criterion;

fn main() {
    minima::print();
    if std::env::args().any(|word| word == "table") {
        return;
    }
    let mut criterion = Criterion::default().configure_from_args();
    chain::bench(&mut criterion);
    active::bench(&mut criterion);
    machine::bench(&mut criterion);
    criterion.final_summary();
}
