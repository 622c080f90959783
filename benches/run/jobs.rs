//! Cycles of a loop in real time: with jobs beside it, and without. Blocks of cycles alternate, so that both see the same machine.

use std::convert::Infallible;
use std::hint::black_box;
use std::thread;
use std::time::{Duration, Instant as Clock};

use bica::prelude::*;
use bica::runner::workers::{Pace, Workers};
use bica::runner::{Jobs, Runner, realtime};
use serde_json::json;

/// Blocks of each loop, and cycles of a block.
const BLOCKS: u32 = 20;
const CYCLES: u64 = 100;
/// Time between two cycles.
const PERIOD: Duration = Duration::from_millis(10);
/// Steps of a computation: nearly 0.04 ms in a cycle, and 11 ms in a job, as the only program of a processor.
const LOAD: u64 = 50_000;
const JOB: u64 = 15_000_000;

fn compute(from: u64, steps: u64) -> u64 {
    (0..steps).fold(from, |sum, step| black_box(sum ^ step).wrapping_mul(31))
}

/// Work of a cycle.
struct Load(u64);

#[component]
impl Load {
    const fn new() -> Self {
        Self(1)
    }

    fn step(&mut self) {
        self.0 = compute(self.0, LOAD);
    }
}

/// Begins a job as soon as the last one has ended.
struct Planner {
    from: u64,
    jobs: u64,
}

#[component]
impl Planner {
    const fn new() -> Self {
        Self { from: 1, jobs: 0 }
    }

    #[work(takes_ms = 30)]
    fn plan(from: u64) -> u64 {
        compute(from, JOB)
    }

    fn step(&mut self, work: &mut Work<Self>, load: &Load) {
        if let Some(result) = work.result() {
            (self.from, self.jobs) = (result ^ load.0, self.jobs + 1);
        }
        if work.is_idle() {
            work.begin(self.from);
        }
    }
}

/// The robot of a tree: its command is a number.
macro_rules! robot {
    ($name:ident, $root:ident: [$($component:ident),*], $command:expr) => {
        activation_tree! { struct $name { root: $root, cycle_hz: 100, components: [$($component),*] } }

        impl Robot for $name {
            type Sensors<'a> = ();
            type Command = u64;
            type Error = Infallible;

            fn sense(&mut self, (): &()) -> Result<(), Infallible> {
                Ok(())
            }

            fn act(&mut self) -> u64 {
                let command: fn(&Self) -> u64 = $command;
                command(self)
            }
        }
    };
}

robot!(Alone, Load: [Load], |robot| robot.get::<Load>().0);
robot!(Planning, Planner: [Planner, Load], |robot| robot.get::<Planner>().jobs);

/// Runs a block of cycles, and adds the time of each; returns the last command.
fn block<T: Robot<Command = u64>, J: Jobs<T>>(
    runner: &mut Runner<Box<T>, (), (), (), J>,
    clock: realtime::Clock,
    times: &mut Vec<Duration>,
) -> u64 {
    let (mut due, mut command) = (clock.now(), 0);
    for _ in 0..CYCLES {
        clock.sleep_until(due);
        let began = Clock::now();
        command = black_box(runner.think(clock.now()));
        times.push(began.elapsed());
        due += bica::Duration::from_micros(PERIOD.as_micros() as u64);
    }
    command
}

/// Measures both loops, and prints a table or a line of JSON.
pub(crate) fn run(is_json: bool) {
    let clock = realtime::Clock::start();
    let mut alone = Runner::new(Box::new(Alone::new()), ());
    let mut planning = Runner::new(Box::new(Planning::new()), ()).with_jobs(Workers::new(1, Pace::RealTime));
    let (mut without, mut with, mut jobs) = (Vec::new(), Vec::new(), 0);
    for _ in 0..BLOCKS {
        block(&mut alone, clock, &mut without);
        jobs = block(&mut planning, clock, &mut with);
        // The last job has ended before the loop without jobs continues.
        thread::sleep(10 * PERIOD);
    }
    let quantile = |times: &mut Vec<Duration>, percent: usize| {
        times.sort_unstable();
        times[times.len() * percent / 100].as_nanos() as f64 / 1000.0
    };
    let rows = [("without jobs", &mut without), ("with jobs", &mut with)]
        .map(|(name, times)| (name, quantile(times, 50), quantile(times, 99)));
    let rise = rows[1].2 - rows[0].2;
    if is_json {
        let rows = rows.map(|(name, p50, p99)| json!({ "name": name, "p50_us": p50, "p99_us": p99 }));
        println!("{}", json!({ "schema": "bica/bench-jobs/1", "rows": rows, "jobs": jobs }));
        return;
    }
    println!("A loop of 100 Hz: time of a cycle, µs{:>12}{:>12}", "median", "p99");
    for (name, p50, p99) in rows {
        println!("{name:<36}{p50:>12.1}{p99:>12.1}");
    }
    println!("{jobs} jobs beside it; p99 rises by {rise:.1} µs");
}
