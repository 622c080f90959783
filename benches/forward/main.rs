//! What the forward costs: its body's algorithms, each of its components alone, and its whole loop.
//!
//! `cargo bench --bench forward`. Compare figures of one run with each other, never with another machine's. What it takes
//! in games, beside what it declares, tells `cargo bench --bench budget`.

#[path = "../support/alone.rs"]
mod alone;
mod body;
mod components;
#[path = "../../tests/forward/game.rs"]
mod game;
#[path = "../vision/recorded.rs"]
mod recorded;
#[path = "../support/recording.rs"]
mod recording;
#[expect(dead_code, reason = "what the benchmarks of vision need of a frame beside its pixels")]
#[path = "../vision/shot.rs"]
mod shot;
mod whole;

use criterion::{criterion_group, criterion_main};

criterion_group!(benches, body::bench, components::bench, whole::bench);
criterion_main!(benches);
