use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = 0.2, range = 0.1..=0.5, step = 0.4)]
    whole: f32,
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0, step = 2.0)]
    gain: f32,
    /// Number.
    #[param(default = -2, range = -2_147_483_648..=2_147_483_647, step = 2_147_483_647)]
    number: i32,
    /// Count.
    #[param(default = 2, range = 1..=3, step = 3)]
    count: u32,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
