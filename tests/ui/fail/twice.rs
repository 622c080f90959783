//! Components, trees, steps, states and entries of a list that exist twice.

use bica::prelude::*;

struct Ball;
#[component]
impl Ball {
    const fn new() -> Self { Self }
}

activation_tree! {
    struct Listed { root: Ball, cycle_hz: 100, components: [Ball, self::Ball] }
}

activation_tree! {
    struct Robot { root: Ball, cycle_hz: 100, components: [Ball] }
}

activation_tree! {
    struct Robot { root: Ball, cycle_hz: 50, components: [Ball], tunable }
}

struct Goalkeeper;

activation_tree! {
    struct Goalkeeper { root: Ball, cycle_hz: 100, components: [Ball] }
}

struct Blocks;
#[component]
impl Blocks {
    const fn new() -> Self { Self }

    fn step(&mut self) {}
}
#[component]
impl Blocks {
    fn look(&mut self) {}
}

struct Steps;
#[component]
impl Steps {
    const fn new() -> Self { Self }
}
impl Steps {
    fn step(&mut self) {}
}

struct States;
#[component]
impl States {
    const fn new() -> Self { Self }

    #[state(initial)]
    fn look(&mut self) {}

    #[state]
    fn look(&mut self) {}

    #[transition(look -> walk)]
    fn seen(&self) -> bool { true }

    #[transition(walk -> look)]
    fn lost(&self) -> bool { true }
}

fn main() {
    Listed::new().tick(Instant::from_ticks(0));
}
