//! Recording of a run.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};

use bica_recording::{Backpressure, Header, ImagePolicy, Recorder, RecorderOptions, Report, Topics, create};
use clap::{Args, ValueEnum};

use crate::console::Failure;

/// Arguments that say how a run is recorded.
#[derive(Clone, Debug, Args)]
pub struct RecordArgs {
    /// Record the run to an MCAP file, for the commands `replay` and `record`
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// What the recording stores of each cycle
    #[arg(long, value_name = "WHICH", default_value = "all", requires = "record")]
    pub images: Images,
    /// Topics for Foxglove, Lichtblick and Rerun in the same file [default: standard; without images none]
    #[arg(long, value_name = "WHICH", requires = "record")]
    pub topics: Option<TopicsArg>,
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

/// Topics for other programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TopicsArg {
    /// None
    None,
    /// Previews of images, frames, shapes, states, parameters and log
    Standard,
    /// The same, and all outputs, sensor values, commands and costs as JSON
    All,
}

impl From<TopicsArg> for Topics {
    fn from(topics: TopicsArg) -> Self {
        match topics {
            TopicsArg::None => Self::None,
            TopicsArg::Standard => Self::Standard,
            TopicsArg::All => Self::All,
        }
    }
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
#[derive(Debug)]
pub struct RecordedFile {
    path: PathBuf,
    /// Receives the reason if the recording ends before the run.
    ended: Receiver<String>,
}

impl RecordArgs {
    /// Returns the topics for other programs.
    #[must_use]
    pub fn topics(&self) -> Topics {
        self.topics.map_or_else(|| ImagePolicy::from(self.images).into(), Topics::from)
    }

    /// Makes the file and writes its header, if a recording is requested. `is_paced` is whether the run cannot wait for the disk.
    pub(crate) fn start(
        &self,
        header: impl FnOnce(ImagePolicy) -> Header,
        is_paced: bool,
    ) -> Result<Option<(RecordedFile, Recorder)>, Failure> {
        let Some(path) = &self.record else { return Ok(None) };
        let header = Header { topics: self.topics(), ..header(self.images.into()) };
        RecordedFile::start(path, self.force, &header, is_paced).map(Some)
    }
}

/// Returns the remedy if a recording cannot begin.
fn begin_help(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::InvalidInput => "rename one of the two, or record with `--topics none`",
        _ => "is the disk full?",
    }
}

impl RecordedFile {
    /// Makes the file, replaces an old one by `force`, and writes its header. `is_paced` is whether the run cannot wait for the disk.
    ///
    /// # Errors
    /// If the file exists, or cannot be written.
    pub fn start(path: &Path, force: bool, header: &Header, is_paced: bool) -> Result<(Self, Recorder), Failure> {
        let help = if path.exists() && !force {
            "--force replaces an existing file"
        } else {
            "name a file that can be made, or written to, with --record"
        };
        let file = create(path, force).map_err(|error| Failure::of_path("write", path, &error, help))?;
        let backpressure = if is_paced { Backpressure::Drop } else { Backpressure::Wait };
        let options = RecorderOptions { backpressure, ..RecorderOptions::default() };
        let (sender, ended) = channel();
        let on_end = move |reason: &str| {
            // The receiver is gone only when the run has ended.
            let _ = sender.send(reason.to_owned());
        };
        let recorder = Recorder::start(file, header, options, on_end)
            .map_err(|error| Failure::of_path("write", path, &error, begin_help(&error)))?;
        Ok((Self { path: path.to_owned(), ended }, recorder))
    }

    /// The path of the file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the reason once if the recording has ended before the run.
    #[must_use]
    pub fn newly_ended(&self) -> Option<String> {
        self.ended.try_recv().ok()
    }

    /// Returns a line for people about the closed file.
    #[must_use]
    pub fn describe(&self, Report { cycles, bytes, dropped_images, reason }: &Report) -> String {
        let dropped = match dropped_images {
            0 => String::new(),
            count => format!("; {count} images dropped, the disk was too slow"),
        };
        let ended = reason.as_ref().map_or_else(String::new, |reason| format!("; it ended before the run: {reason}"));
        let (megabytes, file) = (*bytes as f64 * 1e-6, self.path.display());
        format!("{cycles} cycles, {megabytes:.2} MB in {file}{dropped}{ended}")
    }
}
