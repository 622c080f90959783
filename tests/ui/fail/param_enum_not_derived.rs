use bica::prelude::*;

#[derive(Clone, Copy)]
pub enum Foot {
    Left,
    Right,
}

/// How to kick.
#[derive(Params)]
pub struct Kicking {
    /// The foot.
    #[param(default = Foot::Left)]
    foot: Foot,
}

fn main() {
    let _ = (Tuned::<Kicking>::DEFAULT, Foot::Right);
}
