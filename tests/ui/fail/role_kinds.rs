//! Roles that are none, and roles that bring one component into a signature twice.

use bica::prelude::*;

trait Plain {
    fn distance(&self) -> f32;
}

struct Ask;
#[component]
impl Ask {
    const fn new() -> Self { Self }

    fn step(&mut self, plain: &impl Plain, same: &Body) {}
}

#[role]
trait Ball {
    fn distance(&self) -> f32;
}

#[role]
trait Legs {
    fn walk(&mut self);
}

struct Body;
#[component]
impl Body {
    const fn new() -> Self { Self }
}

impl Plain for Body {
    fn distance(&self) -> f32 { 1.0 }
}

impl Ball for Body {
    fn distance(&self) -> f32 { 1.0 }
}

impl Legs for Body {
    fn walk(&mut self) {}
}

activation_tree! {
    struct OfNoRole { root: Ask, cycle_hz: 100, roles: { Plain: Body }, components: [Ask, Body] }
}

struct Follow;
#[component]
impl Follow {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &impl Ball, legs: &mut impl Legs) {}
}

activation_tree! {
    struct Twice { root: Follow, cycle_hz: 100, roles: { Ball: Body, Legs: Body }, components: [Follow, Body] }
}

struct Lonely;
#[component]
impl Lonely {
    const fn new() -> Self { Self }

    fn step(&mut self, own: &impl Ball) {}
}

impl Ball for Lonely {
    fn distance(&self) -> f32 { 1.0 }
}

activation_tree! {
    struct Circle { root: Lonely, cycle_hz: 100, roles: { Ball: Lonely }, components: [Lonely] }
}

fn main() {
    Twice::new().tick(Instant::from_ticks(0));
    Circle::new().tick(Instant::from_ticks(0));
}
