//! Values that are adjusted while the robot runs, in batches that are applied whole or not at all.
//!
//! `cargo run --example parameters`

use bica::Setting;
use bica::prelude::*;

/// How the cart keeps its distance.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub struct Keeping {
    /// Speed for each metre of distance beyond the wanted one.
    #[param(default = 0.5, range = 0.0..=2.0, unit = "1/s", step = 0.05)]
    gain: f32,
    /// Wanted distance to the wall.
    #[param(default = 0.5, range = 0.1..=2.0, unit = "m")]
    wanted: f32,
    /// Below this distance the cart stops at once.
    #[param(default = 0.2, range = 0.1..=2.0, unit = "m")]
    nearest: f32,
}

impl Keeping {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.nearest <= self.wanted { Ok(()) } else { Err("`nearest` must not be above `wanted`") }
    }
}

/// Drives towards a wall.
pub struct Cart {
    distance: f32,
}

#[component(hz = 50)]
impl Cart {
    const fn new() -> Self {
        Self { distance: 2.0 }
    }

    fn step(&mut self, tuned: &Tuned<Keeping>, time: &Time) {
        let speed = tuned.gain * (self.distance - tuned.wanted);
        let speed = if self.distance < tuned.nearest { speed.min(0.0) } else { speed };
        self.distance -= speed * time.dt();
    }
}

activation_tree! {
    /// The word `tunable` adds memory for the values; without it they are constants.
    struct Robot { root: Cart, cycle_hz: 50, tunable, components: [Cart] }
}

fn main() -> Result<(), Refusal> {
    let mut robot = Robot::new();
    for group in Cart::PARAMS {
        println!("{}: {}", group.name, group.doc);
        for param in group.params {
            println!("  {} = {} {}: {}", param.name, param.default, param.unit.unwrap_or_default(), param.doc);
        }
    }
    // Both in one batch: the first one alone would break the rule.
    let setting = |name, value| Robot::setting("Cart", name, Value::F32(value));
    let batches: [&[Setting]; 3] =
        [&[setting("gain", 2.0)?], &[setting("nearest", 1.0)?], &[setting("wanted", 1.5)?, setting("nearest", 1.0)?]];
    for (second, batch) in batches.into_iter().enumerate() {
        match robot.set_params(batch) {
            Ok(()) => println!("{second} s: gain is {}", robot.params::<Cart>().gain),
            Err(refusal) => println!("{second} s: refused, {refusal}"),
        }
        for cycle in 0..50 {
            robot.tick(Instant::from_millis(1000 * second as u64 + 20 * cycle));
        }
        println!("     at {:.2} m", robot.get::<Cart>().distance);
    }
    Ok(())
}
