use bica::prelude::*;

struct Player;

#[component]
impl Default for Player {
    fn default() -> Self {
        Self
    }
}

fn main() {}
