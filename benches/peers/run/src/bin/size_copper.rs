//! Program with a chain of ten tasks, with copper-rs.

use peers::subject::show;
use peers_copper::{RobotClock, chain_10};

fn main() -> Result<(), String> {
    chain_10(RobotClock::new()).map(show).map_err(|error| error.to_string())
}
