//! Recording of a run.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, channel};

use bica_recording::{Backpressure, Header, ImagePolicy, Recorder, RecorderOptions, Report, create};
use clap::{Args, ValueEnum};

use crate::console::{Console, Failure};

/// Arguments that say how a run is recorded.
#[derive(Clone, Debug, Args)]
pub struct RecordArgs {
    /// Record the run to an MCAP file, for the commands `replay` and `record`
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// What the recording stores of each cycle
    #[arg(long, value_name = "WHICH", default_value = "all", requires = "record")]
    pub images: Images,
    /// Replace the file of --record if it exists
    #[arg(long, requires = "record")]
    pub force: bool,
}

/// What a recording stores of each cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Images {
    /// Images, sensor values and commands; a replay needs nothing else
    All,
    /// Set-up, requests and fingerprints; a replay runs the world again
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

/// File that a run is recorded to.
pub(crate) struct RecordedFile {
    path: PathBuf,
    /// Receives the reason if the recording ends before the run.
    ended: Receiver<String>,
}

impl RecordArgs {
    /// Makes the file and writes its header, if a recording is requested. `is_paced` is whether the run cannot wait for the disk.
    pub(crate) fn start(
        &self,
        header: impl FnOnce(ImagePolicy) -> Header,
        is_paced: bool,
    ) -> Result<Option<(RecordedFile, Recorder)>, Failure> {
        let Some(path) = &self.record else { return Ok(None) };
        let help = if path.exists() && !self.force {
            "--force replaces an existing file"
        } else {
            "name a file that can be made, or written to, with --record"
        };
        let file = create(path, self.force).map_err(|error| Failure::of_path("write", path, &error, help))?;
        let backpressure = if is_paced { Backpressure::Drop } else { Backpressure::Wait };
        let options = RecorderOptions { backpressure, ..RecorderOptions::default() };
        let (sender, ended) = channel();
        let on_end = move |reason: &str| {
            // The receiver is gone only when the run has ended.
            let _ = sender.send(reason.to_owned());
        };
        let recorder = Recorder::start(file, &header(self.images.into()), options, on_end)
            .map_err(|error| Failure::of_path("write", path, &error, "is the disk full?"))?;
        Ok(Some((RecordedFile { path: path.clone(), ended }, recorder)))
    }
}

impl RecordedFile {
    /// Returns the reason once if the recording has ended before the run.
    pub(crate) fn newly_ended(&self) -> Option<String> {
        self.ended.try_recv().ok()
    }

    /// Closes the file and prints its length.
    pub(crate) fn finish(self, recorder: Recorder, result: &str, console: Console) -> Result<(), Failure> {
        let Report { cycles, bytes, dropped_images, reason } = recorder.finish(result);
        let dropped = match dropped_images {
            0 => String::new(),
            count => format!("; {count} images dropped, the disk was too slow"),
        };
        let ended = reason.map_or_else(String::new, |reason| format!("; it ended before the run: {reason}"));
        let (megabytes, file) = (bytes as f64 * 1e-6, self.path.display());
        console.print_row("recording", &format!("{cycles} cycles, {megabytes:.2} MB in {file}{dropped}{ended}"))
    }
}
