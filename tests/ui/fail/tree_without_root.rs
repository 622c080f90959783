use bica::prelude::*;

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }
}

activation_tree! {
    struct Forward { components: [Player] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
