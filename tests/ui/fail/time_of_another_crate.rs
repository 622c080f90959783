
use bica::{Instant, Tree, activation_tree, component};

struct Time;

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, time: &Time) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
