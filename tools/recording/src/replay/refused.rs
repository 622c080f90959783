//! Reason why a recording is not replayed.

use std::error;
use std::fmt;
use std::path::Path;

use crate::error::Error;

/// Reason why a recording is not replayed, with the remedy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// What was wrong.
    pub what: String,
    /// What to do about it.
    pub help: String,
}

impl Refused {
    /// Creates a reason and its remedy.
    pub fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { what: what.into(), help: help.into() }
    }

    /// The failure to read a file.
    pub(super) fn of_file(path: &Path, error: &Error) -> Self {
        Self::new(format!("cannot read `{}`: {error}", path.display()), error.help())
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.what, self.help)
    }
}

impl error::Error for Refused {}
