//! Command line.

use std::path::PathBuf;

use bica_sim::setup::Frame;
use clap::Parser;

use crate::processor::{Processor, Source};

const PROCESSOR: &str = "Estimate for a slower processor, on which the whole chain must keep the deadline";

/// Plays fixed games, measures the time of every run of every component, and prints the chain from sensing to acting
/// with the declared budgets and the tree's deadline. Fails if a declared budget or the deadline is exceeded.
#[derive(Debug, Parser)]
#[command(name = "budget", bin_name = "cargo bench -p bica-benches --bench budget --")]
pub(crate) struct Options {
    /// Size of the images: 160x120, 320x240 or 640x480
    #[arg(long = "size", value_name = "WxH", default_value = "640x480", value_parser = size)]
    pub(crate) frame: Frame,
    /// Number of repetitions of each game, three times as many while a check fails; for every run the minimum time
    /// counts
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) repeats: u32,
    /// Also fail if the chain takes longer than this in more than 1 of 100 cycles, ms
    #[arg(long, value_name = "MS", value_parser = positive)]
    pub(crate) loop_ms: Option<f64>,
    /// Print JSON to stdout, messages to stderr
    #[arg(long)]
    pub(crate) json: bool,
    /// Also draw the bar chart of the documentation
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Clock of the processor, MHz
    #[arg(long, value_name = "F", value_parser = positive, requires = "ipc", help_heading = PROCESSOR)]
    clock_mhz: Option<f64>,
    /// Mean instructions that the processor executes per clock cycle
    #[arg(long, value_name = "I", value_parser = positive, requires = "clock_mhz", help_heading = PROCESSOR)]
    ipc: Option<f64>,
    /// Use the instruction counts of the Cortex-M image (160x120, firmware/figures.txt) instead of those of this
    /// machine
    #[arg(long, requires = "clock_mhz", help_heading = PROCESSOR)]
    firmware: bool,
    /// Passed by `cargo bench`.
    #[arg(long, hide = true)]
    bench: bool,
}

impl Options {
    /// Returns the slower processor, if one is given.
    pub(crate) fn processor(&self) -> Option<Processor> {
        let source = if self.firmware { Source::Firmware } else { Source::Host };
        self.clock_mhz.zip(self.ipc).map(|(mhz, ipc)| Processor { mhz, ipc, source })
    }
}

fn size(text: &str) -> Result<Frame, String> {
    let sides = text.split_once('x').and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)));
    sides
        .and_then(|(width, height)| Frame::of_size(width, height))
        .ok_or_else(|| "the size must be 160x120, 320x240 or 640x480".to_owned())
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| *number > 0.0 && number.is_finite());
    number.ok_or_else(|| "the value must be a number above 0".to_owned())
}
