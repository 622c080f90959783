//! Arguments that exist twice or are too many, and defaults outside their range.

use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0)]
    gain: f32,
}

struct Ball;
#[component]
impl Ball {
    const fn new() -> Self { Self }
}

struct Linked;
#[component]
impl Linked {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &Ball, same: &mut self::Ball) {}
}

activation_tree! {
    struct TwoLinks { root: Linked, cycle_hz: 100, components: [Linked, Ball] }
}

struct Follower;
#[component]
impl Follower {
    const fn new() -> Self { Self }

    fn step(&mut self, tuned: &Tuned<Following>, other: &Tuned<self::Following>) {}
}

activation_tree! {
    struct TwoPaths { root: Follower, cycle_hz: 100, tunable, components: [Follower] }
}

struct Turn {
    speed: f32,
}
#[component]
impl Turn {
    const fn new() -> Self { Self { speed: 0.0 } }

    /// Turns.
    #[modulation]
    fn turn(&mut self, #[range(-1.0..=1.0)] #[default(2.0)] speed: f32) { self.speed = speed; }
}

activation_tree! {
    struct Default { root: Turn, cycle_hz: 100, components: [Turn] }
}

struct Head;
#[component]
impl Head {
    const fn new() -> Self { Self }

    /// Turns.
    #[modulation]
    #[allow(unused_variables)]
    fn turn(
        &mut self,
        a0: bool, a1: bool, a2: bool, a3: bool, a4: bool, a5: bool, a6: bool, a7: bool, a8: bool,
        b0: bool, b1: bool, b2: bool, b3: bool, b4: bool, b5: bool, b6: bool, b7: bool,
    ) {}
}

activation_tree! {
    struct Calls { root: Head, cycle_hz: 100, components: [Head] }
}

struct Room;
#[world_actions]
impl Room {
    /// Pushes.
    #[action]
    #[allow(unused_variables)]
    fn push(
        &mut self,
        a0: bool, a1: bool, a2: bool, a3: bool, a4: bool, a5: bool, a6: bool, a7: bool, a8: bool,
        b0: bool, b1: bool, b2: bool, b3: bool, b4: bool, b5: bool, b6: bool, b7: bool,
    ) {}
}

fn main() {
    TwoLinks::new().tick(Instant::from_ticks(0));
    TwoPaths::new().tick(Instant::from_ticks(0));
    Default::new().tick(Instant::from_ticks(0));
}
