//! Runs that are recorded to several files, the parts.

use std::ffi::OsStr;
use std::hash::{BuildHasher as _, Hasher as _, RandomState};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use bica_wire::model::Invalid;
use serde::{Deserialize, Serialize};

/// Place of a recording among the parts of its run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RunPart {
    /// Number, from 1.
    pub number: u32,
    /// Random text that all parts of the run have in common.
    pub run: String,
}

/// Limit at which a recording continues in the next part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Split {
    /// Longest time of a part by the run's clock, ns.
    Time(u64),
    /// Length of a file, bytes. A part exceeds it by at most one cycle and its own ending.
    Size(u64),
}

/// A unit of a limit: its name, nanoseconds or bytes in one, and the kind of limit.
type Unit = (&'static str, f64, fn(u64) -> Split);

const UNITS: [Unit; 7] = [
    ("s", 1e9, Split::Time),
    ("min", 60e9, Split::Time),
    ("h", 3600e9, Split::Time),
    ("MB", 1e6, Split::Size),
    ("GB", 1e9, Split::Size),
    ("MiB", 1_048_576.0, Split::Size),
    ("GiB", 1_073_741_824.0, Split::Size),
];
/// Shortest part, ns.
const MIN_TIME: u64 = 1_000_000_000;
/// Smallest part, bytes.
const MIN_SIZE: u64 = 1_000_000;
/// Remedy for a wrong limit.
const HELP: &str = "give a time of at least 1s or a size of at least 1MB, as 30s, 10min, 1h, 500MB, 2GB or 2GiB";

impl FromStr for Split {
    type Err = Invalid;

    fn from_str(text: &str) -> Result<Self, Invalid> {
        let wrong = |what: String| Invalid::new(what, HELP);
        let is_digit = |one: char| one.is_ascii_digit() || one == '.';
        let (number, unit) = text.split_at(text.find(|one| !is_digit(one)).unwrap_or(text.len()));
        let unit = unit.trim();
        let found = UNITS.into_iter().find(|(name, ..)| name.eq_ignore_ascii_case(unit));
        let Some((_, scale, limit)) = found else {
            return Err(wrong(match unit {
                "" => format!("`{text}` has no unit"),
                _ => format!("`{unit}` is no unit of time or size"),
            }));
        };
        let number: f64 = number.parse().map_err(|_| wrong(format!("`{text}` does not begin with a number")))?;
        match limit((number * scale) as u64) {
            Self::Time(time) if time < MIN_TIME => Err(wrong(format!("`{text}` is too short"))),
            Self::Size(size) if size < MIN_SIZE => Err(wrong(format!("`{text}` is too small"))),
            limit => Ok(limit),
        }
    }
}

impl RunPart {
    /// The first part of a new run.
    pub(crate) fn first() -> Self {
        Self { number: 1, run: format!("{:016x}", RandomState::new().build_hasher().finish()) }
    }

    /// Returns the path of a part of a split recording: part 2 of `run.mcap` is `run-002.mcap`.
    #[must_use]
    pub fn path(recording: &Path, number: u32) -> PathBuf {
        with_stem(recording, &format!("{}-{number:03}", stem(recording)))
    }

    /// Returns the path of an existing part of a recording, if there is one.
    #[must_use]
    pub fn existing(recording: &Path) -> Option<PathBuf> {
        let folder = recording.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let names = folder.read_dir().ok()?.filter_map(|entry| Some(entry.ok()?.file_name()));
        let number = |name: &OsStr| -> Option<u32> { stem(Path::new(name)).rsplit_once('-')?.1.parse().ok() };
        let is_part = |path: &PathBuf| {
            path.file_name().and_then(number).is_some_and(|number| *path == Self::path(recording, number))
        };
        names.map(|name| recording.with_file_name(name)).find(is_part)
    }

    /// Returns the path of the first part, if the files have kept their names.
    pub(crate) fn first_path(&self, path: &Path) -> Option<PathBuf> {
        let stem = stem(path);
        let stem = stem.strip_suffix(&format!("-{:03}", self.number))?;
        Some(Self::path(&with_stem(path, stem), 1))
    }

    /// Refuses to run a part again that is not the first one of its run.
    pub(crate) fn check_first(&self, path: &Path) -> Result<(), Invalid> {
        if self.number == 1 {
            return Ok(());
        }
        let what =
            format!("`{}` is part {} of a run: a replay needs the start of the run", path.display(), self.number);
        let first = self.first_path(path).map_or_else(|| "part 1".to_owned(), |first| format!("`{}`", first.display()));
        Err(Invalid::new(what, format!("give {first}, or join all parts with `record merge OUT PART...`")))
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

fn with_stem(path: &Path, stem: &str) -> PathBuf {
    let extension = path.extension().map(OsStr::to_string_lossy);
    path.with_file_name(extension.map_or_else(|| stem.to_owned(), |extension| format!("{stem}.{extension}")))
}
