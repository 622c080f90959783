//! Figure 4 of the BICA paper: two components activate the same child, which is still one and runs once.
#![forbid(unsafe_code)]

use bica::prelude::*;

/// Counts its runs.
#[derive(Default)]
struct Head {
    wanted: f32,
    runs: u32,
}

#[component]
impl Head {
    const fn new() -> Self {
        Self { wanted: 0.0, runs: 0 }
    }

    fn step(&mut self) {
        self.runs += 1;
    }
}

struct Ball(f32);

#[component(hz = 30)]
impl Ball {
    const fn new() -> Self {
        Self(0.0)
    }

    /// Sees the ball drift.
    fn step(&mut self) {
        self.0 += 0.1;
    }
}

struct FaceBall;

#[component(hz = 10, budget_us = 40)]
impl FaceBall {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, ball: &Ball, head: &mut Head) {
        head.wanted = ball.0;
    }
}

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn look(&mut self, head: &mut Head) {}

    #[state]
    fn face(&mut self, face: &mut FaceBall) {}

    #[transition(look -> face)]
    fn seen(&self, ball: &Ball) -> bool {
        ball.0 > 0.5
    }

    #[transition(face -> look, after_ms = 1500)]
    fn lost(&self) -> bool {
        true
    }
}

activation_tree! {
    /// Two activators of one head.
    struct Robot {
        root: Player,
        cycle_hz: 100,
        components: [Player, FaceBall, Ball, Head],
    }
}

fn main() {
    let mut robot = Robot::new();
    for tick in 0..300 {
        robot.tick(Instant::from_millis(tick * 10));
        if tick % 25 == 0 {
            let active: Vec<_> = robot.active().map(|id| Robot::GRAPH.nodes[id.index()].name).collect();
            println!(
                "{tick} {:?} {:?} {} {}",
                active,
                robot.state(Robot::id::<Player>()),
                robot.get::<Head>().wanted,
                robot.get::<Head>().runs
            );
        }
    }
}
