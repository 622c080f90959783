//! Private types in a public tree.

use bica::prelude::*;

/// How to follow.
#[derive(Params)]
struct Following {
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0)]
    gain: f32,
}

struct Ball;
#[component]
impl Ball {
    pub const fn new() -> Self { Self }
}

pub struct Player;
#[component]
impl Player {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &Ball, tuned: &Tuned<Following>) {}
}

struct Map;

pub struct Planner;
#[component]
impl Planner {
    const fn new() -> Self { Self }

    #[work(takes_ms = 200)]
    fn search(goal: u8, _: Map) -> u8 { goal }

    fn step(&mut self, work: &mut Work<Self>) { work.begin(3, Map); }
}

activation_tree! {
    pub struct Forward { root: Player, cycle_hz: 100, tunable, components: [Player, Ball] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
