use bica::prelude::*;

#[derive(Clone, Copy, ParamEnum)]
pub enum Foot {
    Left(f32),
    Right,
}

fn main() {
    let _ = (Foot::Left(0.0), Foot::Right);
}
