//! Arguments of `record`.

use std::path::PathBuf;

use bica_link::Address;
use clap::{Args, Subcommand};

use super::file::TopicsArg;
use crate::values::{address, time};

#[derive(Clone, Debug, Args)]
pub(crate) struct Record {
    #[command(subcommand)]
    pub(super) action: RecordAction,
}

#[derive(Clone, Debug, Subcommand)]
pub(super) enum RecordAction {
    /// Print what a recording contains
    Info(InfoArgs),
    /// Write the intact chunks of a cut or damaged recording to a new file
    Recover(Recover),
    /// Write a span of time of a recording to a new file
    Trim(Trim),
    /// Join all parts of a run that was recorded with --split; or merge recordings of several robots, by time, to a file for viewers
    Merge(Merge),
    /// Play a recording to monitors, as if its robot ran
    Play(PlayArgs),
    /// Write a recording of the former format to a new file in the present one
    Upgrade(Files),
}

#[derive(Clone, Debug, Args)]
pub(super) struct InfoArgs {
    /// The recording
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Print the contents as JSON on stdout
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Clone, Debug, Args)]
pub(super) struct Files {
    /// The recording
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    #[command(flatten)]
    pub(super) out: Out,
}

#[derive(Clone, Debug, Args)]
pub(super) struct Merge {
    #[command(flatten)]
    pub(super) out: Out,
    /// All parts of one run, in any order; or recordings of robots, which have the names of their files
    #[arg(value_name = "FILE", required = true)]
    pub(super) files: Vec<PathBuf>,
    /// Topics for Foxglove, Lichtblick and Rerun in the new file [default: those of the recordings]
    #[arg(long, value_name = "WHICH")]
    pub(super) topics: Option<TopicsArg>,
}

#[derive(Clone, Debug, Args)]
pub(super) struct Out {
    /// The new file
    #[arg(value_name = "OUT")]
    pub(super) path: PathBuf,
    /// Replace OUT if it exists
    #[arg(long)]
    pub(super) force: bool,
    /// Print the result as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Clone, Debug, Args)]
pub(super) struct Recover {
    #[command(flatten)]
    pub(super) files: Files,
    /// Topics for Foxglove, Lichtblick and Rerun in the new file [default: those of the recording]
    #[arg(long, value_name = "WHICH")]
    pub(super) topics: Option<TopicsArg>,
}

#[derive(Clone, Debug, Args)]
pub(super) struct Trim {
    #[command(flatten)]
    pub(super) written: Recover,
    /// Begin of the span, s since the first cycle
    #[arg(long, value_name = "S", default_value_t = 0.0, value_parser = time, allow_negative_numbers = true)]
    pub(super) from: f64,
    /// End of the span, s [default: the end of the recording]
    #[arg(long, value_name = "S", value_parser = time, allow_negative_numbers = true)]
    pub(super) until: Option<f64>,
}

#[derive(Clone, Debug, Args)]
pub(super) struct PlayArgs {
    /// The recording
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Where monitors attach: HOST:PORT (port 0: any), or a serial line as /dev/ttyUSB0@921600
    #[arg(long, value_name = "ADDR", value_parser = address)]
    pub(super) serve: Address,
    /// Allow an address of --serve that other computers reach; there is no password
    #[arg(long)]
    pub(super) listen_anywhere: bool,
    /// Speed of time: 2 is twice as fast as recorded, 0.1 a tenth
    #[arg(long, value_name = "X", default_value_t = 1.0, value_parser = speed, allow_negative_numbers = true)]
    pub(super) speed: f64,
    /// Begin here, s since the first cycle
    #[arg(long, value_name = "S", default_value_t = 0.0, value_parser = time, allow_negative_numbers = true)]
    pub(super) from: f64,
    /// End here, s [default: the end of the recording]
    #[arg(long, value_name = "S", value_parser = time, allow_negative_numbers = true)]
    pub(super) until: Option<f64>,
    /// Begin again after the end, until Ctrl-C
    #[arg(long = "loop")]
    pub(super) repeats: bool,
    /// Print the result as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub(super) json: bool,
}

/// Parses a speed of time.
fn speed(text: &str) -> Result<f64, String> {
    let fits = text.parse().ok().filter(|speed: &f64| (0.01..=100.0).contains(speed));
    fits.ok_or_else(|| "give a speed from 0.01 to 100".to_owned())
}
