//! The slowest run of each component of the wall follower beside its budget.

mod robot;
#[expect(dead_code, reason = "its tests use the rest")]
mod room;

use std::process::ExitCode;

use bica::prelude::*;
use bica_app::App;

use robot::{Explorer, WallFollower};
use room::Room;

fn main() -> ExitCode {
    App::<WallFollower>::new("wall_follower")
        .world("room", |_| Room::new())
        .until(|robot| robot.get::<Explorer>().is_done())
        .bench()
}
