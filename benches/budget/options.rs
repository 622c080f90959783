//! What the command line asks for.

use std::path::PathBuf;

use bica_sim::field::Frame;

use crate::smaller::{Smaller, Source};

pub(crate) const HELP: &str = "\
Plays fixed games, measures every component's time per run, and prints the chain from sensing to acting beside the
declared budgets and the tree's deadline. Fails if a declared budget or the deadline is exceeded.

  cargo bench --bench budget -- [OPTIONS]

  --size WxH        size of the images: 160x120, 320x240 or 640x480 (the default)
  --repeats N       how often each game is played (the default is 5), or three times that while something does not hold;
                    of every run the least time counts
  --loop-ms MS      fails too if the chain takes longer in more than 1 of 100 cycles
  --json            prints JSON; what is said to people goes to stderr
  --svg FILE        draws the bars of the README too

For a smaller robot, whose whole chain must be within the deadline:

  --clock-mhz F     its clock, MHz
  --ipc I           instructions that it executes per cycle of its clock, on average
  --firmware        takes the instructions from those that the Cortex-M image executed (160x120, firmware/figures.txt),
                    not from this machine's
";

/// What is to be done.
#[derive(Debug, PartialEq)]
pub(crate) enum Asked {
    Help,
    Report(Options),
}

/// How to report.
#[derive(Debug, PartialEq)]
pub(crate) struct Options {
    pub(crate) frame: Frame,
    pub(crate) repeats: usize,
    /// What the chain may take in 99 of 100 cycles, ms.
    pub(crate) loop_ms: Option<f64>,
    pub(crate) json: bool,
    pub(crate) svg: Option<PathBuf>,
    pub(crate) smaller: Option<Smaller>,
}

/// Reads the words of a command line.
///
/// # Errors
/// The word that can't be understood, and what would be.
pub(crate) fn read(words: impl IntoIterator<Item = String>) -> Result<Asked, String> {
    let mut options = Options { frame: Frame::Large, repeats: 5, loop_ms: None, json: false, svg: None, smaller: None };
    let (mut mhz, mut ipc, mut source) = (None, None, Source::Host);
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("`{word}` wants a value"));
        match word.as_str() {
            // `cargo bench` says so.
            "--bench" => {}
            "--help" | "-h" => return Ok(Asked::Help),
            "--json" => options.json = true,
            "--firmware" => source = Source::Firmware,
            "--svg" => options.svg = Some(value()?.into()),
            "--size" => options.frame = size(&value()?)?,
            "--repeats" => options.repeats = number(&word, &value()?)?.max(1.0) as usize,
            "--loop-ms" => options.loop_ms = Some(number(&word, &value()?)?),
            "--clock-mhz" => mhz = Some(number(&word, &value()?)?),
            "--ipc" => ipc = Some(number(&word, &value()?)?),
            _ => return Err(format!("`{word}` is no option")),
        }
    }
    options.smaller = match (mhz, ipc) {
        (Some(mhz), Some(ipc)) => Some(Smaller { mhz, ipc, source }),
        (None, None) if source == Source::Host => None,
        _ => return Err("a smaller robot needs both `--clock-mhz F` and `--ipc I`".to_owned()),
    };
    Ok(Asked::Report(options))
}

fn size(word: &str) -> Result<Frame, String> {
    let sides = word.split_once('x').and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)));
    sides
        .and_then(|(width, height)| Frame::of_size(width, height))
        .ok_or_else(|| format!("`{word}` is no size of images: 160x120, 320x240 or 640x480"))
}

fn number(option: &str, word: &str) -> Result<f64, String> {
    let number: Option<f64> = word.parse().ok();
    number
        .filter(|number| *number > 0.0 && number.is_finite())
        .ok_or_else(|| format!("`{option}` wants a number greater than 0, not `{word}`"))
}
