//! Recording of a run.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};

use bica_recording::{
    Backpressure, Header, ImagePolicy, Recorder, RecorderOptions, Report, RunPart, Split, Topics, create,
};
use bica_wire::model::Invalid;
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
    /// Go on in another file when one has reached a time or a size, as 10min or 2GB: FILE-001.mcap, FILE-002.mcap, …
    #[arg(long, value_name = "LIMIT", requires = "record", value_parser = limit, allow_hyphen_values = true)]
    pub split: Option<Split>,
    /// Replace the file of --record if it exists; with --split each part
    #[arg(long, requires = "record")]
    pub force: bool,
}

fn limit(text: &str) -> Result<Split, String> {
    text.parse().map_err(|Invalid { what, help, .. }| format!("{what}: {help}"))
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
    /// The same, and all other outputs, sensor values, commands and costs
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

    /// Creates the file and writes its header if a recording is requested. `is_paced` is true if the run cannot wait for the disk.
    pub(crate) fn start(
        &self,
        header: impl FnOnce(ImagePolicy) -> Header,
        is_paced: bool,
    ) -> Result<Option<(RecordedFile, Recorder)>, Failure> {
        let Some(path) = &self.record else { return Ok(None) };
        let header = Header { topics: self.topics(), ..header(self.images.into()) };
        RecordedFile::start(path, self.force, self.split, &header, is_paced).map(Some)
    }
}

/// Remedy if a recording cannot begin.
fn begin_help(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::InvalidInput => "rename one of the two, or record with `--topics none`",
        _ => "is the disk full?",
    }
}

impl RecordedFile {
    /// Creates the file and writes its header; replaces an existing file if `force` is set. With `split` the file is
    /// the first part. `is_paced` is true if the run cannot wait for the disk.
    ///
    /// # Errors
    /// If the file, or a part of the same name, exists and is not replaced, or cannot be written.
    pub fn start(
        path: &Path,
        force: bool,
        split: Option<Split>,
        header: &Header,
        is_paced: bool,
    ) -> Result<(Self, Recorder), Failure> {
        let backpressure = if is_paced { Backpressure::Drop } else { Backpressure::Wait };
        let options = RecorderOptions { backpressure, ..RecorderOptions::default() };
        let (sender, ended) = channel();
        let on_end = move |reason: &str| {
            // The receiver is dropped only when the run has ended.
            let _ = sender.send(reason.to_owned());
        };
        let first = split.map_or_else(|| path.to_owned(), |_| RunPart::path(path, 1));
        let existing = if split.is_some() { RunPart::existing(path) } else { path.exists().then(|| path.to_owned()) };
        if let Some(existing) = existing.filter(|_| !force) {
            let what = "it exists already";
            return Err(Failure::of_path("write", &existing, &what, "--force replaces an existing file"));
        }
        let unwritable = |error: io::Error, help| Failure::of_path("write", &first, &error, help);
        let file = create(&first, force)
            .map_err(|error| unwritable(error, "name a file that can be made, or written to, with --record"))?;
        let recorder = match split {
            None => Recorder::start(file, header, options, on_end),
            Some(split) => {
                let (path, mut file) = (path.to_owned(), Some(file));
                let next = move |number| file.take().map_or_else(|| create(&RunPart::path(&path, number), force), Ok);
                Recorder::start_split(next, split, header, options, on_end)
            }
        };
        let recorder = recorder.map_err(|error| {
            let help = begin_help(&error);
            unwritable(error, help)
        })?;
        Ok((Self { path: first, ended }, recorder))
    }

    /// Path of the file, or of the first part.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the reason if the recording ended before the run; only once.
    #[must_use]
    pub fn newly_ended(&self) -> Option<String> {
        self.ended.try_recv().ok()
    }

    /// Returns a line of text about the closed file.
    #[must_use]
    pub fn describe(&self, Report { cycles, bytes, dropped_images, reason, parts }: &Report) -> String {
        let dropped = match dropped_images {
            0 => String::new(),
            count => format!("; {count} images dropped, the disk was too slow"),
        };
        let ended = reason.as_ref().map_or_else(String::new, |reason| format!("; it ended before the run: {reason}"));
        let (megabytes, file) = (*bytes as f64 * 1e-6, self.path.display());
        let parts = match parts {
            Some(count) if *count > 1 => format!(" and {} more parts", count - 1),
            _ => String::new(),
        };
        format!("{cycles} cycles, {megabytes:.2} MB in {file}{parts}{dropped}{ended}")
    }
}
