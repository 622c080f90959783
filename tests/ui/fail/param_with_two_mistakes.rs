use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = 0.5)]
    gain: f32,
    #[param(default = 1, range = 0..=2)]
    count: u32,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
