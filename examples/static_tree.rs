//! A tree in a `static`, as firmware has it: made by the compiler, no heap, no start-up code, taken once.
//!
//! `cargo run --example static_tree`

use bica::prelude::*;
use static_cell::ConstStaticCell;

/// Blinks the light in the chest.
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

/// Has the light blink faster the longer it is active.
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

/// The robot. A cell that can be taken once makes it the only one.
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
