//! Errors of reading and writing recordings.

use std::fmt;
use std::io;
use std::path::Path;

use bica_wire::model::Invalid;

use crate::header::{FORMAT, MONITOR_FORMAT};

/// Reason why a file cannot be read or written.
#[derive(Debug)]
pub enum Error {
    /// The operating system refused an operation.
    Io(io::Error),
    /// The path names a folder, a pipe or a device.
    NotAFile,
    /// A damaged file has no intact header, so nothing of it can be recovered.
    NoHeader,
    /// Two things have the same name in the new file.
    Names(String),
    /// No cycle of a file can be recovered; the text says what is wrong with the file, and is empty if it is complete.
    NoCycle(String),
    /// The file does not begin as an MCAP file.
    NotMcap,
    /// The file is an MCAP file without the metadata of a recording.
    NotARecording,
    /// The recording has another format than this program.
    Format(u32),
    /// The recording has the former format, which [`upgrade`](crate::upgrade()) reads.
    Former(u32),
    /// The recording has the present format, so it cannot be upgraded.
    Present,
    /// The bytes at a position contradict the format.
    Damaged {
        /// Position in the file, bytes.
        at: u64,
        /// What is wrong there.
        what: String,
    },
    /// A chunk is compressed with a method that this program does not have.
    Compression(String),
    /// The recording has no cycle in a span of time, or ends before the end of the span.
    Span {
        /// Time of the last cycle since the first one, ns.
        end: u64,
    },
    /// The file ends within a record; everything before it is intact.
    CutOff {
        /// Length of the intact part, bytes.
        at: u64,
    },
}

impl Error {
    pub(crate) fn damaged(at: u64, what: impl Into<String>) -> Self {
        Self::Damaged { at, what: what.into() }
    }

    /// Returns the error of reading a file.
    #[must_use]
    pub fn of(&self, path: &Path) -> Invalid {
        Invalid::new(format!("cannot read `{}`: {self}", path.display()), self.help())
    }

    /// Returns the remedy.
    #[must_use]
    pub const fn help(&self) -> &'static str {
        match self {
            Self::Io(_) => "is the file there, and may it be read?",
            Self::Names(_) => "rename one of the two",
            Self::NoCycle(_) => "record the run again: there is nothing to be written to a new file",
            Self::NoHeader => "record the run again: without its header no message of a file can be read",
            Self::NotAFile | Self::NotMcap | Self::NotARecording => "name a file that a run with `--record FILE` wrote",
            Self::Former(_) => "the command `record upgrade FILE NEW` writes it to a new file in the present format",
            Self::Present => "use the file as it is",
            Self::Format(_) => "open it with the version of the program that wrote it, or record the run again",
            Self::Compression(_) => {
                "this program reads LZ4: `mcap compress --compression lz4 FILE --output OUT` writes the file with it"
            }
            Self::Span { .. } => "give times within the recording; the command `record info FILE` shows its length",
            Self::Damaged { .. } | Self::CutOff { .. } => {
                "the command `record recover FILE OUT` writes the intact chunks to a new file"
            }
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => error.fmt(out),
            Self::NotAFile => out.write_str("this is a folder, a pipe or a device, not a file"),
            Self::Names(what) => out.write_str(what),
            Self::NoCycle(damage) if damage.is_empty() => out.write_str("the recording has no cycle"),
            Self::NoCycle(damage) => write!(out, "no cycle can be recovered: {damage}"),
            Self::NoHeader => out.write_str("neither the header nor its copy is intact"),
            Self::NotMcap => out.write_str("this is not an MCAP file"),
            Self::NotARecording => out.write_str(
                "this MCAP file is not a recording of a robot: no metadata record `bica` precedes its messages",
            ),
            Self::Format(format) | Self::Former(format) => {
                write!(
                    out,
                    "the recording has format {format}; this program reads format {FORMAT}, of a monitor {MONITOR_FORMAT}"
                )
            }
            Self::Present => out.write_str("the recording has the present format already"),
            Self::Damaged { at, what } => write!(out, "the file is damaged at byte {at}: {what}"),
            Self::Compression(name) => write!(out, "a chunk is compressed with `{name}`"),
            Self::Span { end } => {
                write!(out, "the recording has no such span: it ends at {:.2} s", *end as f64 * 1e-9)
            }
            Self::CutOff { at } => write!(out, "the file is cut off after byte {at}"),
        }
    }
}

impl std::error::Error for Error {}

impl From<io::Error> for Error {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}
