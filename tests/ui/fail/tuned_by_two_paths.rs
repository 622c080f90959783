use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0)]
    gain: f32,
}

pub struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, tuned: &Tuned<Following>, other: &Tuned<self::Following>) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, tunable, components: [Player] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
