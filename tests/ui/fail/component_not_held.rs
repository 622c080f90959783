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
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player] }
}

fn main() {
    Forward::new().get::<Head>();
}
