use bica::prelude::*;

/// How to follow.
#[derive(Params)]
pub struct Following(f32);

fn main() {
    let _ = Tuned::<Following>::DEFAULT;
}
