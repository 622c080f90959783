//! A generic component without its type.

use bica::prelude::*;

struct Eye<const W: usize>;
#[component]
impl<const W: usize> Eye<W> {
    const fn new() -> Self { Self }
}

struct Player;
#[component]
impl Player {
    const fn new() -> Self { Self }

    fn step(&mut self, eye: &Eye<320>) {}
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player, Eye] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
