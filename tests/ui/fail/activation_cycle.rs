use bica::prelude::*;

struct FaceBall;

#[component]
impl FaceBall {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, head: &mut Head) {}
}

struct Head;

#[component]
impl Head {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, face: &FaceBall) {}
}

activation_tree! {
    struct Forward { root: FaceBall, cycle_hz: 100, components: [FaceBall, Head] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
