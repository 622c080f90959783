//! What the same work would take on a smaller robot.
//!
//! Time is instructions / (clock × instructions per cycle). The instructions are counted, never guessed; that a robot's
//! own processor needs as many is the estimate. Two counts, of two instruction sets, say how far it can be trusted.

use std::fs;
use std::path::Path;
use std::time::Instant as Clock;

use bica::prelude::*;
use bica::runner::Runner;
use bica_sim::setup::Frame;

use bica_benches::recording::{CYCLES, Recording, WARM};

const COUNTED_HERE: &str = "benches/instructions.txt";
const COUNTED_ON_CORTEX: &str = "firmware/figures.txt";
/// How often the recording is played to learn this machine's speed.
const REPEATS: usize = 20;

/// Where the instructions are from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    Host,
    Firmware,
}

/// A robot that is asked about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Smaller {
    pub(crate) mhz: f64,
    pub(crate) ipc: f64,
    pub(crate) source: Source,
}

/// How to come from what is known to what a smaller robot takes.
pub(crate) enum Machine {
    /// From times of this machine, which executes this many instructions in a second.
    Host { asked: Smaller, per_second: f64 },
    /// From the instructions of each component on a Cortex-M: name, median, max.
    Firmware { asked: Smaller, counted: Vec<(String, f64, f64)> },
}

impl Smaller {
    /// Learns what the estimate needs.
    ///
    /// # Errors
    /// What could not be read.
    pub(crate) fn machine(self, frame: Frame) -> Result<Machine, String> {
        match self.source {
            Source::Host => Ok(Machine::Host { asked: self, per_second: per_second(frame)? }),
            Source::Firmware => Ok(Machine::Firmware { asked: self, counted: counted_on_cortex()? }),
        }
    }

    /// Instructions in one µs.
    pub(crate) fn per_us(&self) -> f64 {
        self.mhz * self.ipc
    }
}

/// Instructions of the forward's loop that this machine executes in a second: as many as valgrind counts in a recording,
/// by the time that the same recording takes.
fn per_second(frame: Frame) -> Result<f64, String> {
    let (width, height) = frame.size();
    let name = format!("forward.at_{width}x{height}");
    let text = read(COUNTED_HERE)?;
    let count = text.lines().find_map(|line| line.strip_prefix(&name)?.trim().parse::<f64>().ok());
    let count = count.ok_or_else(|| format!("{COUNTED_HERE} has no `{name}`: cargo xtask budget --bless"))?;
    Ok(count / least_time(frame)?)
}

fn least_time(frame: Frame) -> Result<f64, String> {
    let (recording, robot) = Recording::of_game(frame, WARM, CYCLES);
    let mut runner = Runner::new(robot, ());
    let mut least = f64::INFINITY;
    let mut cycle = 1000;
    for _ in 0..REPEATS {
        let began = Clock::now();
        for sensors in recording.sensors() {
            let now = Instant::from_millis(10 * cycle);
            runner.sense(now, &sensors).map_err(|error| error.to_string())?;
            std::hint::black_box(runner.think(now));
            cycle += 1;
        }
        least = least.min(began.elapsed().as_secs_f64());
    }
    Ok(least)
}

fn counted_on_cortex() -> Result<Vec<(String, f64, f64)>, String> {
    let text = read(COUNTED_ON_CORTEX)?;
    text.lines().filter(|line| !line.starts_with('#')).map(figures).collect()
}

fn figures(line: &str) -> Result<(String, f64, f64), String> {
    let wrong = || format!("{COUNTED_ON_CORTEX}: `{line}` is no name with two numbers");
    let [name, median, max] = line.split(' ').collect::<Vec<_>>()[..] else { return Err(wrong()) };
    let number = |word: &str| word.parse().map_err(|_| wrong());
    Ok((name.to_owned(), number(median)?, number(max)?))
}

fn read(file: &str) -> Result<String, String> {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(file))
        .map_err(|error| format!("cannot read {file}: {error}"))
}
