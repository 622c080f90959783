//! Arguments of `replay`.

use std::path::PathBuf;

use clap::Args;

use crate::values::time;

#[derive(Clone, Debug, Args)]
pub(crate) struct ReplayArgs {
    /// The recording
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Compare from this time on, s since the first cycle; the code runs from the start in any case
    #[arg(long, value_name = "S", default_value_t = 0.0, value_parser = time, allow_negative_numbers = true)]
    pub(super) from: f64,
    /// End at this time, s [default: the end of the recording]
    #[arg(long, value_name = "S", value_parser = time, allow_negative_numbers = true)]
    pub(super) until: Option<f64>,
    /// Compare with another recording instead of running the code
    #[arg(long, value_name = "FILE")]
    pub(super) against: Option<PathBuf>,
    /// Set a parameter to another value than the recorded one; may be repeated
    #[arg(long, value_name = "COMPONENT.NAME=VALUE", conflicts_with = "against")]
    pub(super) set: Vec<String>,
    /// Run the simulated world again, also if the recording has sensor values: the code sees the effect of its own decisions
    #[arg(long, conflicts_with = "against")]
    pub(super) closed_loop: bool,
    /// Print the result as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub(super) json: bool,
}
