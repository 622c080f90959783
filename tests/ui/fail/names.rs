//! Names that are not in scope.

use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0)]
    gain: f32,
}

struct Head;
#[component]
impl Head {
    const fn new() -> Self { Self }
}

struct Player;
#[component]
impl Player {
    const fn new() -> Self { Self }

    fn step(&mut self, head: &Haed, tuned: &Tuned<Folowing>) {}
}

activation_tree! {
    struct Linked { root: Player, cycle_hz: 100, tunable, components: [Player, Head] }
}

struct Seer;
#[component]
impl Seer {
    const fn new() -> Self { Self }

    fn step(&mut self, head: &Head) {}
}

activation_tree! {
    struct Listed { root: Seer, cycle_hz: 100, components: [Seer, Hed, Head] }
}

fn main() {
    Linked::new().tick(Instant::from_ticks(0));
}
