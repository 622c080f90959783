//! What the framework itself costs: visits, runs, machines, each beside the same work written by hand.
//!
//! `cargo bench --bench framework`. Compare figures of one run with each other, never with another machine's.

mod active;
mod chain;
mod machine;
mod ticks;
#[path = "../trees/mod.rs"]
mod trees;

use criterion::{criterion_group, criterion_main};

criterion_group!(benches, chain::bench, active::bench, machine::bench);
criterion_main!(benches);
