use bica::prelude::*;

pub struct Following {
    gain: f32,
}

pub struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, tuned: &Tuned<Following>) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, tunable, components: [Player] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
