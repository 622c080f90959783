//! Items with mistakes that the macros find, which bring no further messages.

use bica::prelude::*;

#[component]
struct Plain;

trait Step {
    fn step(&mut self);
}

struct Stepper;
impl Stepper {
    const fn new() -> Self { Self }
}
#[component]
impl Step for Stepper {
    fn step(&mut self) {}
}

activation_tree! {
    struct Steppers { root: Stepper, cycle_hz: 100, components: [Stepper] }
}

struct Head;
#[component]
impl Head {
    const fn new() -> Self { Self }
}

struct Player;
#[component(hz = 0)]
impl Player {
    const fn new() -> Self { Self }

    async fn step(self, head: Head) -> f32 { 0.0 }
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player, Head] }
}

activation_tree! {
    struct WithoutRoot { components: [Head] }
}

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(range = 0.0..=1.0)]
    gain: f32,
    #[param(default = 1, range = 0..=2)]
    count: u32,
}

struct Follower;
#[component]
impl Follower {
    const fn new() -> Self { Self }

    fn step(&mut self, tuned: &Tuned<Following>) {}
}

activation_tree! {
    struct Followers { root: Follower, cycle_hz: 100, tunable, components: [Follower] }
}

/// Parameters of other types.
#[derive(Params)]
pub struct Others {
    /// Name.
    #[param(default = "x")]
    name: String,
    /// Pause.
    #[param(default = 1, range = 0..=5)]
    pause: Duration,
}

struct Taker;
#[component]
impl Taker {
    const fn new() -> Self { Self }

    fn step(&mut self, others: &Tuned<Others>) {}
}

activation_tree! {
    enum Robot { root: Taker, cycle_hz: 100, tunable, components: [Taker] }
}

fn main() {
    Robot::new().tick(Instant::from_ticks(0));
    Steppers::new().tick(Instant::from_ticks(0));
    Forward::new().tick(Instant::from_ticks(0));
    WithoutRoot::new().tick(Instant::from_ticks(0));
    Followers::new().tick(Instant::from_ticks(0));
    let _ = Tuned::<Following>::DEFAULT;
}

#[message]
struct Sent {
    speed: f32,
}

#[output]
struct Shown {
    speed: f32,
}

#[output]
fn speed() -> f32 { 0.0 }
