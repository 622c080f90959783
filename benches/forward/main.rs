//! What the forward costs: its body's algorithms, each of its components alone, and its whole loop.
//!
//! `cargo bench -p bica-benches --bench forward`. Compare figures of one run with each other, never with another machine's. What it takes
//! in games, beside what it declares, tells `cargo bench -p bica-benches --bench budget`.

mod body;
mod components;
mod whole;

use criterion::{criterion_group, criterion_main};

criterion_group!(benches, body::bench, components::bench, whole::bench);
criterion_main!(benches);
