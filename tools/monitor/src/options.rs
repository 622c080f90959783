//! Options of all sessions.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::path::PathBuf;
use std::time::Duration;

/// Default of [`Options::run`]: a program of [`App`](https://docs.rs/bica-app) in the folder of sources, in its first world.
const RUN: &str = "-- run --serve {address} --seed {seed}";

/// Folders and limits of all sessions.
#[derive(Clone, Debug)]
pub struct Options {
    /// Folder of kept recordings; created when the first recording is kept.
    pub recordings: PathBuf,
    /// Folder of tune files.
    pub tune: PathBuf,
    /// Folder of Rust sources that may be read and edited, if that is allowed.
    pub source: Option<PathBuf>,
    /// Whether pages may check, build and run the code in that folder.
    pub build: bool,
    /// Program that is built and run: `[CARGO-OPTIONS] -- [ARGUMENTS]`, with `{address}`, `{seed}` and `{robots}` in the arguments.
    pub run: String,
    /// File of saved layouts of panels.
    pub layouts: PathBuf,
    /// Folder for the files of running recordings; created when needed.
    pub spool: PathBuf,
    /// Whether pages may only watch.
    pub read_only: bool,
    /// Length of the history of a live session.
    pub ring: Duration,
    /// Largest memory for images, bytes per session.
    pub image_bytes: usize,
    /// Largest memory for outputs, bytes per session.
    pub output_bytes: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            recordings: "recordings".into(),
            tune: "tune".into(),
            source: None,
            build: false,
            run: RUN.to_owned(),
            layouts: "jmanager-layouts.json".into(),
            spool: spool(),
            read_only: false,
            ring: Duration::from_mins(10),
            image_bytes: 32 << 20,
            output_bytes: 40 << 20,
        }
    }
}

/// Folder in the shared temporary directory, with a random name, so that other users cannot create it in advance with symbolic links.
fn spool() -> PathBuf {
    let random = RandomState::new().build_hasher().finish();
    std::env::temp_dir().join(format!("jmanager-{}-{random:016x}", std::process::id()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folder_of_running_recordings_cannot_be_guessed() {
        assert_ne!(Options::default().spool, Options::default().spool);
    }
}
