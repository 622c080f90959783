use bica::prelude::*;

struct Head;

#[component]
impl Head {
    const fn new() -> Self {
        Self
    }

    /// Turns.
    #[modulation]
    #[allow(unused_variables)]
    fn turn(&mut self, a0: bool, a1: bool, a2: bool, a3: bool, a4: bool, a5: bool, a6: bool, a7: bool, a8: bool, a9: bool, a10: bool, a11: bool, a12: bool, a13: bool, a14: bool, a15: bool, a16: bool) {}
}

activation_tree! {
    struct Robot { root: Head, cycle_hz: 100, components: [Head] }
}

struct Room;

#[world_actions]
impl Room {
    /// Pushes.
    #[action]
    #[allow(unused_variables)]
    fn push(&mut self, a0: bool, a1: bool, a2: bool, a3: bool, a4: bool, a5: bool, a6: bool, a7: bool, a8: bool, a9: bool, a10: bool, a11: bool, a12: bool, a13: bool, a14: bool, a15: bool, a16: bool) {}
}

fn main() {}
