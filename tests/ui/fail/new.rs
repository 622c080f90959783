//! Components without a constant `new()`.

use bica::prelude::*;

struct Ball {
    offset: f32,
}
#[component]
impl Ball {}

activation_tree! {
    struct WithoutNew { root: Ball, cycle_hz: 100, components: [Ball] }
}

struct Head {
    offset: f32,
}
#[component]
impl Head {
    const fn new(offset: f32) -> Self { Self { offset } }
}

activation_tree! {
    struct WithArgument { root: Head, cycle_hz: 100, components: [Head] }
}

struct Player;
#[component]
impl Player {
    fn new() -> Self { Self }
}

activation_tree! {
    struct NotConst { root: Player, cycle_hz: 100, components: [Player] }
}

fn main() {
    WithoutNew::new().tick(Instant::from_ticks(0));
    WithArgument::new().tick(Instant::from_ticks(0));
    NotConst::new().tick(Instant::from_ticks(0));
}
