use bica::prelude::*;

#[derive(Clone, Copy, ParamEnum)]
pub struct Foot;

fn main() {
    let _ = Foot;
}
