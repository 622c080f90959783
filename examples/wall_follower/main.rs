//! A two-wheeled robot with a lidar drives once around a room along its walls.
//!
//! `cargo run --example wall_follower` simulates it as fast as possible and prints the track. `cargo run --example
//! wall_follower -- --realtime` runs the same robot in real time at 50 Hz, and prints the statistics of the loop;
//! Ctrl-C ends it.
//!
//! - `robot.rs`: the components, the activation tree, its sensors and its command.
//! - `room.rs`: the simulated world.
//! - `tests.rs`: tests that advance time and check states by name.

mod robot;
mod room;
#[cfg(test)]
mod tests;

use bica::prelude::*;
use bica::runner::realtime::Stop;
use bica::runner::{Cycle, Observer, OverrunPolicy, Runner, Schedule};

use robot::{Explorer, WallFollower};
use room::Room;

/// Maximum duration of the drive, s.
const LIMIT: u64 = 300;

/// Prints the transitions of the root.
struct Story {
    now: Instant,
}

impl Probe for Story {
    fn cycle_begin(&mut self, now: Instant) {
        self.now = now;
    }

    fn transition(&mut self, component: ComponentId, _from: usize, to: usize) {
        if component == WallFollower::id::<Explorer>() {
            let state = &WallFollower::GRAPH.nodes[component.index()].states[to];
            println!("{:6.2} s  {:13} {}", seconds(self.now), state.name, state.doc.trim());
        }
    }
}

impl Observer<WallFollower> for Story {
    /// A recorder or a plot would read the command here.
    fn acted(&mut self, _cycle: &Cycle<'_, WallFollower>) {}
}

fn seconds(now: Instant) -> f64 {
    now.as_micros() as f64 * 1e-6
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut robot = WallFollower::new();
    let mut runner = Runner::new(&mut robot, Room::new()).with_observer(Story { now: Instant::MIN });
    let is_done = |robot: &WallFollower| robot.get::<Explorer>().is_done();

    if std::env::args().any(|word| word == "--realtime") {
        let mut schedule = Schedule::new(WallFollower::GRAPH.cycle_hz, OverrunPolicy::Skip);
        let stop = Stop::on_ctrl_c()?;
        runner.run(&mut schedule, &stop, |runner| !is_done(runner.robot()))?;
        println!("{schedule}");
    } else {
        while !is_done(runner.robot()) && runner.world().time() < LIMIT {
            runner.cycle()?;
        }
    }
    println!("{}", runner.world());
    Ok(())
}
