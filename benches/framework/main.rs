//! What the framework itself costs: visits, runs, machines, each beside the same work written by hand.
//!
//! `cargo bench --bench framework`. Compare figures of one run with each other, never with another machine's.

mod chain;
mod machine;

use criterion::{criterion_group, criterion_main};

criterion_group!(benches, chain::bench, machine::bench);
criterion_main!(benches);
