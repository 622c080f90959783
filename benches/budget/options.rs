//! What the command line asks for.

use std::path::PathBuf;

use bica_sim::setup::Frame;
use clap::Parser;

use crate::smaller::{Smaller, Source};

const SMALLER: &str = "For a smaller robot, whose whole chain must be within the deadline";

/// Plays fixed games, measures every component's time per run, and prints the chain from sensing to acting beside the
/// declared budgets and the tree's deadline. Fails if a declared budget or the deadline is exceeded.
#[derive(Debug, Parser)]
#[command(name = "budget", bin_name = "cargo bench -p bica-benches --bench budget --")]
pub(crate) struct Options {
    /// Size of the images: 160x120, 320x240 or 640x480
    #[arg(long = "size", value_name = "WxH", default_value = "640x480", value_parser = size)]
    pub(crate) frame: Frame,
    /// How often each game is played, or three times that while something does not hold; of every run the least time counts
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) repeats: u32,
    /// Fail too if the chain takes longer in more than 1 of 100 cycles, ms
    #[arg(long, value_name = "MS", value_parser = positive)]
    pub(crate) loop_ms: Option<f64>,
    /// Print JSON; what is said to people goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
    /// Draw the bars of the README too
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Its clock, MHz
    #[arg(long, value_name = "F", value_parser = positive, requires = "ipc", help_heading = SMALLER)]
    clock_mhz: Option<f64>,
    /// Instructions that it executes per cycle of its clock, on average
    #[arg(long, value_name = "I", value_parser = positive, requires = "clock_mhz", help_heading = SMALLER)]
    ipc: Option<f64>,
    /// Take the instructions from those that the Cortex-M image executed (160x120, firmware/figures.txt), not from this
    /// machine's
    #[arg(long, requires = "clock_mhz", help_heading = SMALLER)]
    firmware: bool,
    /// `cargo bench` says so.
    #[arg(long, hide = true)]
    bench: bool,
}

impl Options {
    /// The smaller robot that is asked about.
    pub(crate) fn smaller(&self) -> Option<Smaller> {
        let source = if self.firmware { Source::Firmware } else { Source::Host };
        self.clock_mhz.zip(self.ipc).map(|(mhz, ipc)| Smaller { mhz, ipc, source })
    }
}

fn size(text: &str) -> Result<Frame, String> {
    let sides = text.split_once('x').and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)));
    sides
        .and_then(|(width, height)| Frame::of_size(width, height))
        .ok_or_else(|| "the cameras give 160x120, 320x240 or 640x480".to_owned())
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| *number > 0.0 && number.is_finite());
    number.ok_or_else(|| "a number greater than 0 is needed".to_owned())
}
