//! Watching a tree: how often each component runs and how long it takes, without a line of that in the components.
//!
//! `cargo run --release --example probe`

use std::time;

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

/// Counts runs and adds up the time of each component's own code; children are not in it.
struct Stopwatch {
    began: time::Instant,
    runs: [u32; Robot::COUNT],
    spent: [time::Duration; Robot::COUNT],
}

impl Probe for Stopwatch {
    fn run(&mut self, component: ComponentId) {
        self.runs[component.index()] += 1;
    }

    fn begin(&mut self, _: ComponentId) {
        self.began = time::Instant::now();
    }

    fn end(&mut self, component: ComponentId) {
        self.spent[component.index()] += self.began.elapsed();
    }
}

fn main() {
    let mut robot = Robot::new();
    let began = time::Instant::now();
    let mut watch = Stopwatch { began, runs: [0; Robot::COUNT], spent: [time::Duration::ZERO; Robot::COUNT] };
    for cycle in 0..1000 {
        robot.tick_with(Instant::from_millis(10 * cycle), &mut watch);
    }
    println!("ten simulated seconds in {:?}", began.elapsed());
    for (node, (runs, spent)) in Robot::GRAPH.nodes.iter().zip(watch.runs.into_iter().zip(watch.spent)) {
        println!(
            "{:8} {runs:5} runs, {:?} each, of {:?} µs",
            node.name,
            spent / runs.max(1),
            node.budget_us.unwrap_or(0.0)
        );
    }
}
