use bica::prelude::*;

struct Head;

#[component]
impl Head {
    const fn new() -> Self {
        Self
    }
}

struct Player;

#[component(hz = 0)]
impl Player {
    const fn new() -> Self {
        Self
    }

    async fn step(self, head: Head) -> f32 {
        0.0
    }
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player, Head] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
