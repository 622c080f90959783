//! Robot whose components write lines of text, for tests: a step, a job, a world, and a flood of lines. With the world `clock` jobs run in
//! real time.

use std::convert::Infallible;
use std::hint::black_box;
use std::process::ExitCode;

use bica::prelude::*;
use bica::runner::{Robot, World};
use bica_app::App;

/// Writes a line in every tenth cycle, and 500 in the cycle of its 100th run.
struct Talker {
    runs: u32,
}

#[component]
impl Talker {
    const fn new() -> Self {
        Self { runs: 0 }
    }

    fn step(&mut self, thinker: &Thinker) {
        if self.runs.is_multiple_of(10) {
            log::info!("run {}", self.runs);
            log::debug!("{} jobs", thinker.jobs);
        }
        let flood = if self.runs == 100 { 500 } else { 0 };
        for number in 0..flood {
            log::error!("flood {number}");
        }
        self.runs += 1;
    }
}

/// Has a job at a time.
struct Thinker {
    jobs: u32,
}

#[component]
impl Thinker {
    const fn new() -> Self {
        Self { jobs: 0 }
    }

    /// Takes up to a cycle, which depends on the number.
    #[work(takes_ms = 100)]
    fn think(number: u32) -> u32 {
        log::warn!("job {number}");
        for step in 0..number * 7 % 20 * 500_000 {
            black_box(step);
        }
        number + 1
    }

    fn step(&mut self, work: &mut Work<Self>) {
        self.jobs = work.result().unwrap_or(self.jobs);
        if work.is_idle() {
            work.begin(self.jobs);
        }
    }
}

activation_tree! { struct Chat { root: Talker, cycle_hz: 50, components: [Talker, left = Thinker] } }

#[data]
struct Sensors;

impl Robot for Chat {
    type Sensors<'a> = Sensors;
    type Command = u32;
    type Error = Infallible;

    fn sense(&mut self, _: &Sensors) -> Result<(), Infallible> {
        Ok(())
    }

    fn act(&mut self) -> u32 {
        self.get::<Thinker>().jobs
    }
}

struct Room(u64);

impl World<Chat> for Room {
    fn now(&self) -> Instant {
        Instant::from_millis(20 * self.0)
    }

    fn sensors(&mut self) -> Sensors {
        if self.0 == 7 {
            log::info!("a door opens");
        }
        Sensors
    }

    fn act(&mut self, _: &u32) {
        self.0 += 1;
    }
}

fn main() -> ExitCode {
    App::<Chat>::new("talker").world("room", |_| Room(0)).device("clock", |_| Ok(Room(0))).run()
}
