//! Quality of self-localization: the robot starts at a random pose and looks around for ten seconds.
//!
//! `cargo run --release -p bica-evaluation --features measure --example localize` prints the failures and the statistics; `-- --help`
//! lists the options.

#[path = "../tests/support/lookout.rs"]
mod lookout;

use bica_sim::setup::Frame;
use clap::Parser;
use lookout::Lookout;

/// Measures self-localization from random poses in the built-in world
#[derive(Parser)]
#[command(name = "localize")]
struct Options {
    /// Number of poses
    #[arg(long, value_name = "N", default_value_t = 100)]
    games: u64,
    /// Number of other robots
    #[arg(long, value_name = "N", default_value_t = 0)]
    robots: usize,
    /// Seed of the first pose
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Moves the robot to another pose after ten seconds, and judges the estimate ten seconds later
    #[arg(long)]
    kidnap: bool,
    /// Lets the robot play for ten more seconds
    #[arg(long)]
    play: bool,
    /// Width of the images, px: 160, 320 or 640
    #[arg(long, value_name = "PX", default_value = "320", value_parser = frame)]
    width: Frame,
}

fn frame(width: &str) -> Result<Frame, String> {
    let width = width.parse().ok();
    width.and_then(|width: usize| Frame::of_size(width, width * 3 / 4)).ok_or("it is 160, 320 or 640".into())
}

fn main() {
    let options = Options::parse();
    let play = |seed| {
        let mut lookout = Lookout::new(seed, options.robots, options.width);
        let outcome = lookout.look_around(10.0);
        if options.play {
            lookout.play();
            return lookout.look_around(10.0);
        }
        if !options.kidnap {
            return outcome;
        }
        lookout.kidnap(seed + 1000, options.robots);
        lookout.look_around(10.0)
    };
    let outcomes: Vec<_> = (options.seed..options.seed + options.games).map(play).collect();
    lookout::print(&outcomes);
}
