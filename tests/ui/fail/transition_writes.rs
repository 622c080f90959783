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

    #[state(initial)]
    fn look(&mut self) {}

    #[state]
    fn walk(&mut self) {}

    #[transition(look -> walk)]
    fn seen(&self) -> bool {
        true
    }

    #[transition(walk -> look)]
    fn lost(&mut self, head: &mut Head) -> bool {
        true
    }
}

activation_tree! {
    struct Forward {
        root: Player,
        cycle_hz: 100,
        components: [Player, Head],
    }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
