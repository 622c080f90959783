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
    fn turn(&mut self, #[range(-1.0..=1.0)] #[default(2.0)] speed: f32) {
        self.speed = speed;
    }
}

activation_tree! {
    struct Robot { root: Turn, cycle_hz: 100, components: [Turn] }
}

fn main() {
    Robot::new().tick(Instant::from_ticks(0));
}
