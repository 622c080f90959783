//! Cost of the forward: algorithms of its body, each component alone, and the whole loop.
//!
//! `cargo bench -p bica-benches --bench forward`. Figures of one run may be compared with each other, never with
//! figures of another machine. `cargo bench -p bica-benches --bench budget` compares the times in games with the
//! declared budgets.

mod body;
mod components;
mod whole;

use criterion::{criterion_group, criterion_main};

criterion_group!(benches, body::bench, components::bench, whole::bench);
criterion_main!(benches);
