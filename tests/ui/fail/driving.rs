//! A motion that tools cannot end.

use bica::prelude::*;

struct Legs;
#[component]
impl Legs {
    const fn new() -> Self { Self }

    /// Walks.
    #[modulation(drives)]
    fn walk(
        &mut self,
        #[range(0.1..=0.4)] #[unit("m/s")] forward: f32,
        #[range(-1.0..=1.0)] #[unit("rad/s")] turn: f32,
    ) { let _ = (forward, turn); }
}

fn main() {}
