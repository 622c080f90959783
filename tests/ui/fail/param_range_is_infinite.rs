use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = 3.0, range = 0.0..=f32::INFINITY)]
    gain: f32,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
