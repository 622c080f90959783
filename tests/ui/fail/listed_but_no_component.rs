use bica::prelude::*;

struct Head;

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

    fn step(&mut self, head: &mut Head) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, tunable, components: [Player, Head] }
}

fn main() {
    let mut forward = Forward::new();
    forward.tick(Instant::from_ticks(0));
}
