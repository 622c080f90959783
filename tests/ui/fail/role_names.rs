//! Roles by names of what is no trait.

use bica::prelude::*;

struct Body;
#[component]
impl Body {
    const fn new() -> Self { Self }
}

struct OfAStruct;
#[component]
impl OfAStruct {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &impl Body) {}
}

struct Unknown;
#[component]
impl Unknown {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &impl Nothing) {}
}

activation_tree! {
    struct OfNothing { root: Body, cycle_hz: 100, roles: { Nobody: Body }, components: [Body] }
}

fn main() {}
