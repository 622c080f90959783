use bica::prelude::*;

struct Ball;

#[component]
impl Ball {
    const fn new() -> Self {
        Self
    }
}

struct Head;

#[component]
impl Head {
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

    fn step(&mut self, ball: &Ball, head: &mut Head) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player, Ball = Head::new(), Head] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
