//! Quality of self-localization: the robot starts at a random pose and looks around for ten seconds.
//!
//! ```text
//! cargo run --release -p bica-evaluation --features measure --example localize -- --games 100 \
//!     [--robots 4] [--seed 0] [--kidnap 1] [--width 160]
//! ```
//!
//! The program prints the failures and the statistics. `--width` is the width of the images, px: 160, 320 or 640. With
//! `--kidnap 1` the robot is moved to another pose after ten seconds, and the estimate is judged ten seconds later.

#[path = "../tests/support/lookout.rs"]
mod lookout;

use bica_sim::setup::Frame;
use lookout::Lookout;

fn main() {
    let words: Vec<String> = std::env::args().collect();
    let number = |name: &str, default: u64| {
        let at = words.iter().position(|word| word == name);
        at.and_then(|at| words.get(at + 1)?.parse().ok()).unwrap_or(default)
    };
    let (games, robots, first) = (number("--games", 100), number("--robots", 0) as usize, number("--seed", 0));
    let width = number("--width", 320) as usize;
    let size = Frame::of_size(width, width * 3 / 4).expect("a width of 160, 320 or 640");
    let play = |seed| {
        let mut lookout = Lookout::new(seed, robots, size);
        let outcome = lookout.look_around(10.0);
        if number("--kidnap", 0) == 0 {
            return outcome;
        }
        lookout.kidnap(seed + 1000, robots);
        lookout.look_around(10.0)
    };
    let outcomes: Vec<_> = (first..first + games).map(play).collect();
    lookout::print(&outcomes);
}
