//! Estimate of the same work on a slower processor.
//!
//! Time is instructions / (clock × instructions per clock cycle). The instructions are counted. The assumption is that
//! the target processor needs as many; the counts of two instruction sets show how accurate this is.

use std::fs;
use std::path::Path;
use std::time::Instant as Clock;

use bica::prelude::*;
use bica::runner::Runner;
use bica_sim::setup::Frame;

use bica_benches::recording::{CYCLES, Recording, WARM};
use bica_player::Forward;

const COUNTED_HERE: &str = "benches/instructions.txt";
const COUNTED_ON_CORTEX: &str = "firmware/figures.txt";
/// Number of repetitions of the recording from which the speed of this machine is measured.
const REPEATS: usize = 20;

/// Source of the instruction counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    Host,
    Firmware,
}

/// Processor for which times are estimated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Processor {
    pub(crate) mhz: f64,
    pub(crate) ipc: f64,
    pub(crate) source: Source,
}

/// Data from which the times on another processor follow.
pub(crate) enum Basis {
    /// Times of this machine and its instruction rate, 1/s.
    Host { processor: Processor, per_second: f64 },
    /// Instructions of each component on a Cortex-M: name, median, maximum.
    Firmware { processor: Processor, counted: Vec<(String, f64, f64)> },
}

impl Processor {
    /// Measures or reads the data for the estimate.
    ///
    /// # Errors
    /// If a file of counts cannot be read.
    pub(crate) fn basis(self, frame: Frame) -> Result<Basis, String> {
        match self.source {
            Source::Host => Ok(Basis::Host { processor: self, per_second: per_second(frame)? }),
            Source::Firmware => Ok(Basis::Firmware { processor: self, counted: counted_on_cortex()? }),
        }
    }

    /// Instructions per µs.
    pub(crate) fn per_us(&self) -> f64 {
        self.mhz * self.ipc
    }
}

/// Measures the instruction rate of this machine in the forward's loop, 1/s: valgrind's count for a recording divided
/// by the minimum time of that recording.
fn per_second(frame: Frame) -> Result<f64, String> {
    let (width, height) = frame.size();
    let name = format!("forward.at_{width}x{height}");
    let text = read(COUNTED_HERE)?;
    let count = text.lines().find_map(|line| line.strip_prefix(&name)?.trim().parse::<f64>().ok());
    let count = count.ok_or_else(|| format!("{COUNTED_HERE} has no `{name}`; run `cargo xtask budget --bless`"))?;
    Ok(count / minimum_time(frame)?)
}

fn minimum_time(frame: Frame) -> Result<f64, String> {
    let (recording, robot) = Recording::of_game::<Forward>(frame, WARM, CYCLES);
    let mut runner = Runner::new(robot, ());
    let mut minimum = f64::INFINITY;
    let mut cycle = 1000;
    for _ in 0..REPEATS {
        let began = Clock::now();
        for sensors in recording.sensors() {
            let now = Instant::from_millis(10 * cycle);
            runner.sense(now, &sensors).map_err(|error| error.to_string())?;
            std::hint::black_box(runner.think(now));
            cycle += 1;
        }
        minimum = minimum.min(began.elapsed().as_secs_f64());
    }
    Ok(minimum)
}

fn counted_on_cortex() -> Result<Vec<(String, f64, f64)>, String> {
    let text = read(COUNTED_ON_CORTEX)?;
    text.lines().filter(|line| !line.starts_with('#')).map(figures).collect()
}

fn figures(line: &str) -> Result<(String, f64, f64), String> {
    let wrong = || format!("{COUNTED_ON_CORTEX}: `{line}` is not a name with two numbers");
    let [name, median, max] = line.split(' ').collect::<Vec<_>>()[..] else { return Err(wrong()) };
    let number = |word: &str| word.parse().map_err(|_| wrong());
    Ok((name.to_owned(), number(median)?, number(max)?))
}

fn read(file: &str) -> Result<String, String> {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(file))
        .map_err(|error| format!("cannot read {file}: {error}"))
}
