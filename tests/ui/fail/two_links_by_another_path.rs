use bica::prelude::*;

struct Ball;

#[component]
impl Ball {
    const fn new() -> Self {
        Self
    }
}

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, ball: &Ball, same: &mut self::Ball) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player, Ball] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
