//! A tree in a `static`, as in firmware: initialised at compile time, without heap, and taken once.
//!
//! `cargo run --example static_tree`

use bica::prelude::*;
use static_cell::ConstStaticCell;

/// Blinking light in the chest.
struct Light {
    on: bool,
}

#[component(hz = 2)]
impl Light {
    const fn new() -> Self {
        Self { on: false }
    }

    fn step(&mut self) {
        self.on = !self.on;
    }
}

/// Raises the blink rate with the time since it became active.
struct Alarm;

#[component(hz = 1)]
impl Alarm {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, light: &mut Light, rate: &mut Rate<Light>, time: &Time) {
        rate.set(0.5 + 0.5 * time.in_state_s() as f32);
    }
}

activation_tree! {
    struct Robot {
        root: Alarm,
        cycle_hz: 10,
        components: [Alarm, Light],
    }
}

/// The only robot; the cell can be taken once.
static ROBOT: ConstStaticCell<Robot> = ConstStaticCell::new(Robot::new());

fn main() {
    let robot = ROBOT.take();
    println!("{} components in {} bytes", Robot::COUNT, size_of::<Robot>());
    let mut before = false;
    for ms in (0..8000).step_by(100) {
        robot.tick(Instant::from_millis(ms));
        let on = robot.get::<Light>().on;
        if on != before {
            println!("{ms:4} ms: {}", if on { "on" } else { "off" });
        }
        before = on;
    }
}
