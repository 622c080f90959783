//! One behaviour on two robots: it names what it needs, and each tree names who provides it.
//!
//! `cargo run --example roles`

use bica::prelude::*;

/// What a behaviour needs to know of the way ahead.
#[role]
trait Sight {
    /// Free distance ahead, m.
    fn free_distance(&self) -> f32;
}

/// What moves the robot.
#[role]
trait Drive {
    /// Requests a speed, m/s.
    fn drive(&mut self, speed: f32);
}

/// Drives on until something is near.
struct Cruise;

#[component]
impl Cruise {
    fn step(&mut self, sight: &impl Sight, wheels: &mut impl Drive) {
        wheels.drive((sight.free_distance() - 0.3).clamp(0.0, 0.5));
    }
}

/// Range of a sensor on a real robot, m; here it comes nearer in each run.
struct Sonar {
    range: f32,
}

#[component(hz = 10)]
impl Sonar {
    const fn new() -> Self {
        Self { range: 1.2 }
    }

    fn step(&mut self) {
        self.range -= 0.05;
    }
}

impl Sight for Sonar {
    fn free_distance(&self) -> f32 {
        self.range
    }
}

struct Wheels {
    speed: f32,
}

#[component]
impl Wheels {
    const fn new() -> Self {
        Self { speed: 0.0 }
    }
}

impl Drive for Wheels {
    fn drive(&mut self, speed: f32) {
        self.speed = speed;
    }
}

activation_tree! {
    struct Robot {
        root: Cruise,
        cycle_hz: 50,
        roles: { Sight: Sonar, Drive: Wheels },
        components: [Cruise = Cruise, Sonar, Wheels],
    }
}

/// A distance that a test sets.
struct Distance(f32);

#[component]
impl Distance {}

impl Sight for Distance {
    fn free_distance(&self) -> f32 {
        self.0
    }
}

activation_tree! {
    /// The same behaviour with a made-up distance.
    struct Trial {
        root: Cruise,
        cycle_hz: 50,
        roles: { Sight: Distance, Drive: Wheels },
        components: [Cruise = Cruise, Distance = Distance(0.4), Wheels],
    }
}

fn main() {
    let mut robot = Robot::new();
    for ms in (0..2000).step_by(20) {
        robot.tick(Instant::from_millis(ms));
        if ms % 400 == 0 {
            println!("{ms:4} ms: {:.2} m free, {:.2} m/s", robot.get::<Sonar>().range, robot.get::<Wheels>().speed);
        }
    }
    println!("{}", Robot::GRAPH.mermaid());

    let mut trial = Trial::new();
    trial.tick(Instant::from_millis(0));
    println!("A wall at {} m: {:.2} m/s", trial.get::<Distance>().0, trial.get::<Wheels>().speed);
}
