use bica::prelude::*;

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

    fn step(&mut self, head: &Haed) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player, Head] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
