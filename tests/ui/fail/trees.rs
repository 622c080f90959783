//! Trees that cannot run: cycles, components that nothing activates, rates and budgets, children of several writers.

use bica::prelude::*;

struct FaceBall;
#[component]
impl FaceBall {
    const fn new() -> Self { Self }

    fn step(&mut self, head: &mut Head) {}
}

struct Head;
#[component]
impl Head {
    const fn new() -> Self { Self }

    fn step(&mut self, face: &FaceBall) {}
}

activation_tree! {
    struct Cycle { root: FaceBall, cycle_hz: 100, components: [FaceBall, Head] }
}

struct Itself;
#[component]
impl Itself {
    const fn new() -> Self { Self }

    fn step(&mut self, other: &self::Itself) {}
}

activation_tree! {
    struct LinkToItself { root: Itself, cycle_hz: 100, components: [Itself] }
}

struct Arm;
#[component(hz = 100, budget_us = 9000)]
impl Arm {
    const fn new() -> Self { Self }
}

struct Leg;
#[component(budget_us = 3000)]
impl Leg {
    const fn new() -> Self { Self }

    fn step(&mut self, arm: &mut Arm) {}
}

activation_tree! {
    struct Load { root: Leg, cycle_hz: 100, components: [Leg, Arm] }
}

struct Player;
#[component(hz = 20, budget_us = 3000)]
impl Player {
    const fn new() -> Self { Self }

    fn step(&mut self, arm: &mut Arm) {}
}

activation_tree! {
    struct Chain { root: Player, cycle_hz: 100, budget_ms: 10, components: [Player, Arm] }
}

activation_tree! {
    struct Slow { root: Arm, cycle_hz: 50, components: [Arm] }
}

activation_tree! {
    struct Inactive { root: Arm, cycle_hz: 100, components: [Arm, Player] }
}

struct Wheels;
#[component]
impl Wheels {
    const fn new() -> Self { Self }
}

struct Avoid;
#[component]
impl Avoid {
    const fn new() -> Self { Self }

    fn step(&mut self, wheels: &mut Wheels) {}
}

struct Follow;
#[component]
impl Follow {
    const fn new() -> Self { Self }

    #[state(initial)]
    fn search(&mut self) {}

    #[state]
    fn chase(&mut self, wheels: &mut Wheels) {}

    #[transition(search -> chase)]
    fn seen(&self) -> bool { true }

    #[transition(chase -> search)]
    fn lost(&self) -> bool { true }
}

struct Pilot;
#[component]
impl Pilot {
    const fn new() -> Self { Self }

    fn step(&mut self, avoid: &mut Avoid, follow: &mut Follow) {}
}

activation_tree! {
    struct TwoWriters { root: Pilot, cycle_hz: 100, components: [Pilot, Avoid, Follow, Wheels] }
}

fn main() {
    Cycle::new().tick(Instant::from_ticks(0));
}
