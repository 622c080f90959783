//! Two components activate the same child. It is one instance, runs once in a cycle, and is latent if neither needs it.
//!
//! `cargo run --example shared_child`

use bica::prelude::*;

/// Counter of the frames taken.
struct Camera {
    frames: u32,
}

#[component(hz = 30)]
impl Camera {
    const fn new() -> Self {
        Self { frames: 0 }
    }

    fn step(&mut self) {
        self.frames += 1;
    }
}

struct Ball;

#[component(hz = 30)]
impl Ball {
    fn step(&mut self, camera: &Camera) {}
}

struct Goal;

#[component(hz = 10)]
impl Goal {
    fn step(&mut self, camera: &Camera) {}
}

/// Requires the ball in every cycle, and the goal in every other second. What it knows of the goal has an age.
struct Striker {
    goal_age: Option<Duration>,
}

#[component]
impl Striker {
    #[state(initial)]
    fn chase(&mut self, ball: &Ball, age: &Age<Goal>) {
        self.goal_age = age.since_run();
    }

    #[state]
    fn aim(&mut self, ball: &Ball, goal: &Goal, age: &Age<Goal>) {
        self.goal_age = age.since_run();
    }

    #[transition(chase -> aim, after_ms = 1000)]
    #[transition(aim -> chase, after_ms = 1000)]
    fn second_is_over(&self) -> bool {
        true
    }
}

activation_tree! {
    struct Robot {
        root: Striker,
        cycle_hz: 100,
        // Each component is `new()`, unless the list gives a value.
        components: [Striker = Striker { goal_age: None }, Ball = Ball, Goal = Goal, Camera],
    }
}

fn main() {
    let mut robot = Robot::new();
    for ms in (0..4000).step_by(10) {
        robot.tick(Instant::from_millis(ms));
        if ms % 500 == 250 {
            let active = robot.active().map(|id| Robot::GRAPH.nodes[id.index()].name).collect::<Vec<_>>();
            let age =
                robot.get::<Striker>().goal_age.map_or("never".into(), |age| format!("{} ms ago", age.as_millis()));
            let frames = robot.get::<Camera>().frames;
            println!("{ms:4} ms: {frames:2} frames; goal seen {age}; active: {}", active.join(", "));
        }
    }
}
