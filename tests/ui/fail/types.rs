//! Types that an argument, an output or a parameter cannot have.

use bica::visual::{Point2, Pose2};
use bica::{Instant, Params, Tree, Tuned, activation_tree, component};

struct Time;

struct Plain {
    gain: f32,
}

struct Player;
#[component]
impl Player {
    const fn new() -> Self { Self }

    fn step(&mut self, time: &Time, tuned: &Tuned<Plain>) {}
}

activation_tree! {
    struct Tunable { root: Player, cycle_hz: 100, tunable, components: [Player] }
}

activation_tree! {
    struct Untunable { root: Player, cycle_hz: 100, components: [Player] }
}

enum Kind {
    Post,
}

struct Ball;
#[component]
impl Ball {
    const fn new() -> Self { Self }

    /// Kind of the obstacle.
    #[output]
    fn kind(&self) -> Kind { Kind::Post }

    /// Distance to the ball.
    #[output(unit = "m", frame = "robot")]
    fn distance(&self) -> f32 { 0.0 }

    /// The ball.
    #[output(unit = "m", frame = "robot", child = "ball")]
    fn ball(&self) -> Option<Point2> { None }

    /// The robot.
    #[output(frame = "field", child = "robot")]
    fn robot(&self) -> Option<&Pose2> { None }
}

#[derive(Clone, Copy)]
pub enum Foot {
    Left,
    Right,
}

/// How to kick.
#[derive(Params)]
#[params(check = Self::is_good)]
pub struct Kicking {
    /// The foot.
    #[param(default = Foot::Left)]
    foot: Foot,
    /// Gain.
    #[param(default = true, range = 0.0..=2.0)]
    gain: f32,
}

impl Kicking {
    const fn is_good(&self) -> bool { self.gain > 0.0 }
}

fn main() {
    Tunable::new().tick(Instant::from_ticks(0));
    let _ = (Tuned::<Kicking>::DEFAULT, Foot::Right);
}
