use bica::prelude::*;

struct Player;

#[component]
impl Player {
    fn new() -> Self {
        Self
    }
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
