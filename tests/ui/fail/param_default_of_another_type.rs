use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = true, range = 0.0..=2.0)]
    gain: f32,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
