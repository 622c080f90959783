use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Gains.
    #[param(default = [0.5; 2])]
    gains: [f32; 2],
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
