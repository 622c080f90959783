use bica::prelude::*;

struct Ball;

#[component]
impl Ball {
    pub const fn new() -> Self {
        Self
    }
}

pub struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, ball: &Ball) {}
}

activation_tree! {
    pub struct Forward { root: Player, cycle_hz: 100, components: [Player, Ball] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
