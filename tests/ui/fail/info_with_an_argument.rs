use bica::prelude::*;

struct Turn {
    speed: f32,
}

#[component]
impl Turn {
    const fn new() -> Self {
        Self { speed: 0.0 }
    }

    /// Speed.
    #[info]
    fn speed(&self, scale: f32) -> f32 {
        self.speed * scale
    }
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
