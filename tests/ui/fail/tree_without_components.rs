use bica::prelude::*;

activation_tree! {
    struct Forward {
        root: Player,
        cycle_hz: 100,
        components: [],
    }
}

fn main() {}
