use bica::prelude::*;

#[derive(Clone, Copy, ParamEnum)]
pub enum Foot {
    Left,
    Right,
}

const USUAL: Foot = Foot::Right;

/// How to kick.
#[derive(Params)]
pub struct Kicking {
    /// The foot.
    #[param(default = USUAL)]
    foot: Foot,
}

fn main() {
    let _ = Tuned::<Kicking>::DEFAULT;
}
