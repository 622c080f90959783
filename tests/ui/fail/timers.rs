//! Timers without the unit of a time.

use bica::prelude::*;

/// Times.
#[derive(Params)]
struct Times {
    /// It has another unit.
    #[param(default = 1.0, range = 0.0..=9.0, unit = "m")]
    distance: f32,
    /// It has none.
    #[param(default = 1, range = 0..=9)]
    count: u32,
    /// It is one.
    #[param(default = 1, range = 0..=9, unit = "ms")]
    pause: u32,
}

struct Boss;
#[component]
impl Boss {
    const fn new() -> Self { Self }

    #[state(initial)]
    #[transition(work -> rest, after = Times::distance)]
    #[transition(work -> work, after = Times::pause)]
    fn work(&mut self) {}

    #[state]
    #[transition(rest -> work, after = Times::count)]
    fn rest(&mut self) {}
}

activation_tree! {
    struct Robot { root: Boss, cycle_hz: 10, components: [Boss] }
}

fn main() {}
