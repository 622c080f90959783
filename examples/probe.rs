//! Observing a tree: number of runs and run time of each component, without additional code in the components.
//!
//! `cargo run --release --example probe`

use std::time;

use bica::Stopwatch;
use bica::prelude::*;

struct Vision {
    sum: u64,
}

#[component(hz = 30, budget_us = 2000)]
impl Vision {
    fn step(&mut self) {
        self.sum = (0..76_800).fold(self.sum, |sum, pixel| sum.rotate_left(7) ^ pixel);
    }
}

struct Walk;

#[component(hz = 100, budget_us = 200)]
impl Walk {
    fn step(&mut self) {}
}

struct Player;

#[component(hz = 10, budget_us = 20)]
impl Player {
    fn step(&mut self, vision: &Vision, walk: &mut Walk) {}
}

activation_tree! {
    struct Robot {
        root: Player,
        cycle_hz: 100,
        budget_ms: 10,
        components: [Player = Player, Vision = Vision { sum: 0 }, Walk = Walk],
    }
}

fn main() {
    let began = time::Instant::now();
    let mut watch: Stopwatch<_, { Robot::COUNT }> = Stopwatch::new(|| began.elapsed().as_nanos() as u64);
    let mut robot = Robot::new();
    for cycle in 0..1000 {
        robot.tick_with(Instant::from_millis(10 * cycle), &mut watch);
    }
    println!("ten simulated seconds in {:?}", began.elapsed());
    for (node, spent) in Robot::GRAPH.nodes.iter().zip(watch.spent()) {
        let each = time::Duration::from_nanos(spent.total / spent.runs.max(1));
        println!("{:8} {:5} runs, {each:?} each, of {:?} µs", node.name, spent.runs, node.budget_us.unwrap_or(0.0));
    }
}
