//! A two-wheeled robot with a lidar drives once around a room along its walls.
//!
//! `cargo run --example wall_follower` simulates it as fast as possible and prints the track; with `-- --realtime` it runs in
//! real time. `-- --help` lists the other commands.
//!
//! - `robot.rs`: the components, the activation tree, its sensors and its command.
//! - `room.rs`: the simulated world.
//! - `budgets.rs`: the benchmark, `cargo bench -p bica-app --bench wall_follower`.
//! - `tests.rs`: tests that advance time and check states by name.

mod robot;
mod room;
#[cfg(test)]
mod tests;

use std::process::ExitCode;

use bica::prelude::*;
use bica_app::App;

use robot::{Explorer, WallFollower};
use room::Room;

fn main() -> ExitCode {
    App::<WallFollower>::new("wall_follower")
        .world("room", |_| Room::new())
        .until(|robot| robot.get::<Explorer>().is_done())
        .run()
}
