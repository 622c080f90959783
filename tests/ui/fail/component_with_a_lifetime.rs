use bica::prelude::*;

struct Player<'a>(&'a str);

#[component]
impl<'a> Player<'a> {
    fn step(&mut self) {}
}

fn main() {}
