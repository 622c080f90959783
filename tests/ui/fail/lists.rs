//! Trees whose lists of components lack one, or hold what is none.

use bica::prelude::*;

struct Head;
#[component]
impl Head {
    const fn new() -> Self { Self }
}

struct Player;
#[component]
impl Player {
    const fn new() -> Self { Self }

    fn step(&mut self, head: &mut Head) {}
}

activation_tree! {
    struct WithoutChild { root: Player, cycle_hz: 100, components: [Player] }
}

activation_tree! {
    struct WithoutRoot { root: Player, cycle_hz: 100, components: [Head] }
}

activation_tree! {
    struct HeadOnly { root: Head, cycle_hz: 100, components: [Head] }
}

static SHARED: HeadOnly = HeadOnly::new();

struct Plain;
impl Plain {
    const fn new() -> Self { Self }
}

activation_tree! {
    struct WithPlain { root: Head, cycle_hz: 100, tunable, components: [Head, Plain] }
}

struct Eye<const W: usize>;
#[component]
impl<const W: usize> Eye<W> {
    const fn new() -> Self { Self }
}

struct Seer;
#[component]
impl Seer {
    const fn new() -> Self { Self }

    fn step(&mut self, eye: &Eye<320>) {}
}

activation_tree! {
    struct OtherSize { root: Seer, cycle_hz: 100, components: [Seer, Eye<640>] }
}

activation_tree! {
    struct OtherValue { root: Player, cycle_hz: 100, components: [Player = Head::new(), Head] }
}

fn main() {
    WithoutChild::new().tick(Instant::from_ticks(0));
    HeadOnly::new().get::<Player>();
    WithPlain::new().tick(Instant::from_ticks(0));
}
