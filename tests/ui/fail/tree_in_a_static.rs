use bica::prelude::*;

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player] }
}

static ROBOT: Forward = Forward::new();

fn main() {}
