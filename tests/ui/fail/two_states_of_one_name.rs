use bica::prelude::*;

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn look(&mut self) {}

    #[state]
    fn look(&mut self) {}

    #[transition(look -> walk)]
    fn seen(&self) -> bool {
        true
    }

    #[transition(walk -> look)]
    fn lost(&self) -> bool {
        true
    }
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
