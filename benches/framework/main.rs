//! What the framework itself costs: visits, runs, machines, each beside the same work written by hand.
//!
//! `cargo bench -p bica-benches --bench framework` prints least times of small and large trees beside each other, then Criterion's
//! figures; `cargo bench -p bica-benches --bench framework -- table` the least times alone. Compare figures of one run with each other,
//! never with another machine's.

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
