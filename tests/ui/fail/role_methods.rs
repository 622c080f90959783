//! A method that no role can have; the components and trees that use the role have no further mistakes.

use bica::prelude::*;

#[role]
trait Legs {
    fn walk(&mut self);

    fn step_length() -> f32;
}

struct Body;
#[component]
impl Body {
    const fn new() -> Self { Self }
}

impl Legs for Body {
    fn walk(&mut self) {}

    fn step_length() -> f32 { 0.1 }
}

struct Follow;
#[component]
impl Follow {
    const fn new() -> Self { Self }

    fn step(&mut self, legs: &mut impl Legs) { legs.walk(); }
}

activation_tree! {
    struct Robot { root: Follow, cycle_hz: 100, roles: { Legs: Body }, components: [Follow, Body] }
}

fn main() {
    Robot::new().tick(Instant::from_ticks(0));
}
