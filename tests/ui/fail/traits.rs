//! Traits in the places of types. The compiler offers `dyn` there, which no link can be; in what the macros write it offers nothing.

use bica::prelude::*;

#[role]
trait Ball {
    fn distance(&self) -> f32;
}

struct Eye;
#[component]
impl Eye {
    const fn new() -> Self { Self }
}
impl Ball for Eye {
    fn distance(&self) -> f32 { 1.0 }
}

struct Reader;
#[component]
impl Reader {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &Ball, age: &Age<Ball>) {}
}

struct Follow;
#[component]
impl Follow {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &impl Ball) {}
}

activation_tree! {
    struct Listed { root: Follow, cycle_hz: 100, roles: { Ball: Eye }, components: [Follow, Eye, Ball] }
}

activation_tree! {
    struct Provided { root: Follow, cycle_hz: 100, roles: { Ball: Clone }, components: [Follow, Eye] }
}

fn main() {}
