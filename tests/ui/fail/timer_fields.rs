//! Timers that are no numbers, or no fields.

use bica::prelude::*;

/// Times.
#[derive(Params)]
struct Times {
    /// No number.
    #[param(default = true)]
    waits: bool,
}

struct Boss;
#[component]
impl Boss {
    const fn new() -> Self { Self }

    #[state(initial)]
    #[transition(work -> rest, after = Times::waits)]
    fn work(&mut self) {}

    #[state]
    #[transition(rest -> work, after = Times::wait)]
    fn rest(&mut self) {}
}

struct Reach;

struct Follower;
#[component]
impl Follower {
    const fn new() -> Self { Self }

    #[state(initial)]
    #[transition(work -> rest, after = Reach::pause)]
    fn work(&mut self) {}

    #[state(last)]
    fn rest(&mut self) {}
}

fn main() {}
