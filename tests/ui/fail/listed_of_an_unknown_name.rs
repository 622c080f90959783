use bica::prelude::*;

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, ball: &Ball) {}
}

struct Ball;

#[component]
impl Ball {
    const fn new() -> Self {
        Self
    }
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player, Bal, Ball] }
}

fn main() {}
