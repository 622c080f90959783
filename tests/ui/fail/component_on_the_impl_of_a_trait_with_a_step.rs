use bica::prelude::*;

trait Step {
    fn step(&mut self);
}

struct Player;

impl Player {
    const fn new() -> Self {
        Self
    }
}

#[component]
impl Step for Player {
    fn step(&mut self) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
