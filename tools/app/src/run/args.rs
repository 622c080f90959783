//! Arguments of `run`.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use log::LevelFilter;

use crate::link::ServeArgs;
use crate::params::{Layer, TuningArgs};
use crate::record::RecordArgs;
use crate::values::seconds;

/// Arguments of `run`.
#[derive(Clone, Debug, Args)]
pub struct RunArgs<L: Layer> {
    /// World to run in
    #[arg(long, value_name = "WORLD", required = false)]
    pub world: String,
    /// Seed of everything random in the world; the same seed gives the same run, bit for bit
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Option of the world; may be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    pub option: Vec<String>,
    /// Run in real time instead of as fast as possible
    #[arg(long)]
    pub realtime: bool,
    /// Longest duration of the run, in seconds of the world [default: until the run is over, or Ctrl-C]
    #[arg(long, value_name = "S", value_parser = seconds, allow_negative_numbers = true)]
    pub seconds: Option<f64>,
    /// How the run is recorded
    #[command(flatten)]
    pub record: RecordArgs,
    /// How the run is served
    #[command(flatten)]
    pub link: ServeArgs,
    /// Values of the parameters
    #[command(flatten)]
    pub tuning: TuningArgs<L>,
    /// Least level of the lines that components write with the crate `log` [default: info]
    #[arg(long, value_name = "LEVEL", value_parser = level())]
    pub log: Option<LevelFilter>,
    /// Print the result as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub json: bool,
}

/// Parses a level of the log.
fn level() -> impl TypedValueParser<Value = LevelFilter> {
    PossibleValuesParser::new(["off", "error", "warn", "info", "debug", "trace"])
        .try_map(|name| name.parse::<LevelFilter>())
}
