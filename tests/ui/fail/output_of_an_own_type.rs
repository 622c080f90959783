use bica::prelude::*;

enum Kind {
    Post,
}

struct Obstacle;

#[component]
impl Obstacle {
    const fn new() -> Self {
        Self
    }

    /// Kind of the obstacle.
    #[info]
    fn kind(&self) -> Kind {
        Kind::Post
    }
}

activation_tree! {
    struct Forward { root: Obstacle, cycle_hz: 100, components: [Obstacle] }
}

fn main() {
    Forward::new().tick(Instant::from_ticks(0));
}
