//! Errors of a command, with a remedy.

use std::fmt;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use bica_wire::model::Invalid;

/// Reason for which a command cannot continue.
#[derive(Debug)]
pub enum Failure {
    /// Wrong arguments, files or environment: exit code 2.
    Error {
        /// What was found.
        what: String,
        /// Remedy.
        help: String,
    },
    /// The reader of stdout has closed it: exit code 141, without a message.
    BrokenPipe,
}

impl Failure {
    /// Creates an error with its remedy.
    #[must_use]
    pub fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Error { what: what.into(), help: help.into() }
    }

    /// Returns the same error with its place in front of the text.
    #[must_use]
    pub fn at(self, place: &str) -> Self {
        match self {
            Self::Error { what, help } => Self::new(format!("{place}: {what}"), help),
            Self::BrokenPipe => self,
        }
    }

    /// Creates an error of reading or writing a file or folder; `action` is a verb, such as "write".
    #[must_use]
    pub fn of_path(action: &str, path: &Path, error: &dyn fmt::Display, help: &str) -> Self {
        Self::new(format!("cannot {action} `{}`: {error}", path.display()), help)
    }
}

impl From<Invalid> for Failure {
    fn from(Invalid { what, help, .. }: Invalid) -> Self {
        Self::new(what, help)
    }
}

impl From<Failure> for Invalid {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Error { what, help } => Self::new(what, help),
            Failure::BrokenPipe => Self::new("stdout is closed", "keep its reader open"),
        }
    }
}

impl From<bica_link::Error> for Failure {
    fn from(error: bica_link::Error) -> Self {
        Self::new(error.to_string(), error.help())
    }
}

/// Conversion of an error of stdout.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::BrokenPipe,
            _ => Self::new(format!("cannot write the output: {error}"), "is the disk full?"),
        }
    }
}

impl From<Failure> for ExitCode {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Error { what, help } => {
                // If stderr is closed too, only the exit code remains.
                let _ = write!(io::stderr(), "error: {what}\n  help: {help}\n");
                Self::from(2)
            }
            // The code that a shell reports for a program ended by SIGPIPE.
            Failure::BrokenPipe => Self::from(141),
        }
    }
}
