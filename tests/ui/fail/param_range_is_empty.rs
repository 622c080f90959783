use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gain.
    #[param(default = 3, range = 5..=1)]
    gain: u32,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
