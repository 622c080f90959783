use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = 1.5, range = 0.0..=1.0)]
    gain: f32,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
