use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Whether to follow.
    #[param(default = true, range = false..=true)]
    follows: bool,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
