//! Defaults, ranges, steps and rules of parameters.

use bica::prelude::*;

/// Gains.
#[derive(Params)]
pub struct Gains {
    /// Outside its range.
    #[param(default = 1.5, range = 0.0..=1.0)]
    outside: f32,
    /// Empty range.
    #[param(default = 3, range = 5..=1)]
    empty: u32,
    /// Infinite range.
    #[param(default = 3.0, range = 0.0..=f32::INFINITY)]
    infinite: f32,
    /// No step.
    #[param(default = 0.5, range = 0.0..=1.0, step = 0.0)]
    still: f32,
    /// Step as large as the range.
    #[param(default = 0.2, range = 0.1..=0.5, step = 0.4)]
    whole: f32,
    /// Step larger than the range.
    #[param(default = 0.5, range = 0.0..=1.0, step = 2.0)]
    large: f32,
    /// Largest step.
    #[param(default = -2, range = -2_147_483_648..=2_147_483_647, step = 2_147_483_647)]
    number: i32,
    /// Count.
    #[param(default = 2, range = 1..=3, step = 3)]
    count: u32,
}

#[derive(Clone, Copy, ParamEnum)]
pub enum Foot {
    Left,
    Right,
}

const USUAL: Foot = Foot::Right;

/// How to kick.
#[derive(Params)]
pub struct Kicking {
    /// The foot.
    #[param(default = USUAL)]
    foot: Foot,
}

/// How to turn.
#[derive(Params)]
pub struct Turning {
    /// The foot.
    #[param(default = Foot::Lefft)]
    foot: Foot,
}

/// How to follow.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub struct Following {
    /// Nearest.
    #[param(default = 2.0, range = 0.0..=3.0)]
    near: f32,
    /// Farthest.
    #[param(default = 1.0, range = 0.0..=3.0)]
    far: f32,
}

impl Following {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.near <= self.far { Ok(()) } else { Err("`near` must not be above `far`") }
    }
}

/// How it turns.
#[derive(Params)]
struct Head {
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0)]
    gain: f32,
}
#[component]
impl Head {
    const fn new() -> Self { Self { gain: 0.5 } }

    fn step(&mut self) { self.gain = 0.0; }
}

fn main() {
    let _ = (Tuned::<Gains>::DEFAULT, Tuned::<Kicking>::DEFAULT, Tuned::<Turning>::DEFAULT, Tuned::<Following>::DEFAULT);
}
