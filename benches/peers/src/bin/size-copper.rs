//! Program with a chain of ten tasks, with copper-rs.

fn main() -> Result<(), String> {
    peers::copper::chain_10(cu29::clock::RobotClock::new()).map(peers::subject::show).map_err(|error| error.to_string())
}
