
use bica::{Instant, Tree, activation_tree, component};

struct Rate;

#[component]
impl Rate {
    const fn new() -> Self {
        Self
    }
}

activation_tree! {
    struct Forward {
        root: Rate,
        cycle_hz: 100,
        components: [Rate],
    }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
