use bica::prelude::*;

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }
}

activation_tree! {
    enum Forward {
        root: Player,
        cycle_hz: 100,
        components: [Player],
    }
}

fn main() {}
