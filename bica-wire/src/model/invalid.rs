//! Error for a name or value that does not fit.

use core::fmt;
use std::format;
use std::string::String;

/// A name that the tree does not have, or a value that does not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Invalid {
    /// What is wrong.
    pub what: String,
    /// Remedy.
    pub help: String,
    /// Index of the wrong setting or argument.
    pub entry: Option<usize>,
}

impl Invalid {
    /// An error with its remedy.
    #[must_use]
    pub fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { what: what.into(), help: help.into(), entry: None }
    }

    /// Returns the same error with the place in front of its text.
    #[must_use]
    pub fn within(self, place: &str) -> Self {
        Self { what: format!("{place}: {}", self.what), ..self }
    }

    pub(super) fn at(self, entry: usize) -> Self {
        Self { entry: Some(entry), ..self }
    }
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)
    }
}

impl core::error::Error for Invalid {}
