use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following {
    /// Whether to follow.
    #[param(default = true, unit = "m")]
    follows: bool,
}

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
