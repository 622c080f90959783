use bica::prelude::*;

#[component]
fn step() {}

fn main() {}
