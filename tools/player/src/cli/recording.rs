//! Arguments about recordings of games.

use std::path::PathBuf;

use bica_recording::ImagePolicy;
use clap::{Args, ValueEnum};

/// What a recording stores of each cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Images {
    /// Images, sensor values and commands; a replay needs nothing else
    All,
    /// Rules, requests and fingerprints; a replay plays the game in its world again
    None,
}

impl From<Images> for ImagePolicy {
    fn from(images: Images) -> Self {
        match images {
            Images::All => Self::All,
            Images::None => Self::None,
        }
    }
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Replay {
    /// The recording
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// Compare from this time on, s; the code runs from the start in any case
    #[arg(long, value_name = "S", default_value_t = 0.0, value_parser = time, allow_negative_numbers = true)]
    pub(crate) from: f64,
    /// End at this time, s [default: the end of the recording]
    #[arg(long, value_name = "S", value_parser = time, allow_negative_numbers = true)]
    pub(crate) until: Option<f64>,
    /// Compare with another recording instead of running the code
    #[arg(long, value_name = "FILE")]
    pub(crate) against: Option<PathBuf>,
    /// Set a parameter to another value than the recorded one; may be repeated
    #[arg(long, value_name = "COMPONENT.NAME=VALUE", conflicts_with = "against")]
    pub(crate) set: Vec<String>,
    /// Run the simulated world again, also if the recording has images: the code sees the effect of its own decisions
    #[arg(long, conflicts_with = "against")]
    pub(crate) closed_loop: bool,
    /// Print the result as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

fn time(text: &str) -> Result<f64, String> {
    let fits = text.parse().ok().filter(|time: &f64| (0.0..=1e9).contains(time));
    fits.ok_or_else(|| "give a time in seconds, 0 or more".to_owned())
}
