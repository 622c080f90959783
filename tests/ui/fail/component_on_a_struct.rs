use bica::prelude::*;

#[component]
struct Player;

fn main() {}
