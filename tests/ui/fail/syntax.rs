//! Syntax errors in a body, in a signature and in an attribute.

use bica::prelude::*;

struct Ball;
#[component]
impl Ball {
    const fn new() -> Self { Self }
}

struct Body;
#[component]
impl Body {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &Ball) {
        let distance = ;
    }
}

activation_tree! {
    struct Bodies { root: Body, cycle_hz: 100, components: [Body, Ball] }
}

struct Signature;
#[component]
impl Signature {
    const fn new() -> Self { Self }

    fn step(&mut self, ball &Ball) {}
}

activation_tree! {
    struct Signatures { root: Signature, cycle_hz: 100, components: [Signature, Ball] }
}

struct Assigned;
#[component = 30]
impl Assigned {
    const fn new() -> Self { Self }

    fn step(&mut self) {}
}

activation_tree! {
    struct Assignment { root: Assigned, cycle_hz: 100, components: [Assigned] }
}

fn main() {
    Bodies::new().tick(Instant::from_ticks(0));
    Signatures::new().tick(Instant::from_ticks(0));
}
