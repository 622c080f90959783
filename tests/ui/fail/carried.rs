//! Transitions that carry something else than their state takes.

use bica::{Found, component};

struct Kick;
struct Pass;

struct Player;
#[component]
impl Player {
    const fn new() -> Self { Self }

    #[state(initial)]
    fn look(&mut self) {}

    #[state]
    fn kick(&mut self) {}

    #[transition(look | kick -> kick)]
    fn near(&self) -> Option<Pass> { None }

    #[transition(kick -> look)]
    fn kicked(&self) -> bool { true }

    #[entry(kick)]
    fn choose(&mut self, kick: Found<Kick>) {}
}

fn main() {}
