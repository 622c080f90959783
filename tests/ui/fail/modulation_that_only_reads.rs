use bica::prelude::*;

struct Turn {
    speed: f32,
}

#[component]
impl Turn {
    const fn new() -> Self {
        Self { speed: 0.0 }
    }

    /// Turns.
    #[modulation]
    fn turn(&self) {}
}

activation_tree! {
    struct Robot {
        root: Turn,
        cycle_hz: 100,
        components: [Turn],
    }
}

fn main() {
    Robot::new().tick(Instant::from_ticks(0));
}
