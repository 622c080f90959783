use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    gain: f32,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
