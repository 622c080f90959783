use bica::prelude::*;

struct Head;

#[component(budget_us = 900)]
impl Head {
    const fn new() -> Self {
        Self
    }
}

struct Player;

#[component(budget_us = 300)]
impl Player {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, head: &mut Head) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, budget_ms: 1, components: [Player, Head] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
