//! Roles that the compiler does not find a component for.

use bica::prelude::*;

#[role]
trait Ball {
    fn distance(&self) -> f32;
}

#[role]
trait Legs {
    fn walk(&mut self);

    fn is_walking(&self) -> bool;
}

struct Follow;
#[component]
impl Follow {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &impl Ball, legs: &mut impl Legs) {}
}

struct Eye;
#[component]
impl Eye {
    const fn new() -> Self { Self }
}

impl Ball for Eye {
    fn distance(&self) -> f32 { 1.0 }
}

impl Legs for Eye {
    fn walk(&mut self) {}

    fn is_walking(&self) -> bool { false }
}

struct Body;
#[component]
impl Body {
    const fn new() -> Self { Self }
}

impl Legs for Body {
    fn walk(&mut self) {}

    fn is_walking(&self) -> bool { true }
}

activation_tree! {
    struct WithoutProvider { root: Follow, cycle_hz: 100, roles: { Ball: Eye }, components: [Follow, Eye, Body] }
}

activation_tree! {
    struct WithoutListed { root: Follow, cycle_hz: 100, roles: { Ball: Eye, Legs: Body }, components: [Follow, Eye] }
}

activation_tree! {
    struct WithoutTrait { root: Follow, cycle_hz: 100, roles: { Ball: Body, Legs: Body }, components: [Follow, Body] }
}

struct Watch;
#[component]
impl Watch {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &impl Ball, eye: &Eye) {}
}

activation_tree! {
    struct WithoutUse {
        root: Watch,
        cycle_hz: 100,
        roles: { Ball: Eye, Legs: Eye },
        components: [Watch, Eye],
    }
}

struct Guard;
#[component]
impl Guard {
    const fn new() -> Self { Self }

    fn step(&mut self, ball: &impl Ball, watch: &mut Watch, follow: &mut Follow) {}
}

activation_tree! {
    struct WithoutAny { root: Guard, cycle_hz: 100, components: [Guard, Watch, Follow, Eye, Body] }
}

fn main() {
    WithoutProvider::new().tick(Instant::from_ticks(0));
    WithoutTrait::new().tick(Instant::from_ticks(0));
}
