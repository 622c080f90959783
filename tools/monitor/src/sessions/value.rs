//! Errors for pages.

use bica_link::Invalid;

use crate::protocol::Failed;

impl Failed {
    /// An error with its remedy.
    #[must_use]
    pub fn new(text: impl Into<String>, help: impl Into<String>) -> Self {
        Self { text: text.into(), help: help.into(), entry: None, stale: false }
    }

    /// An error of a request about an older version of a text.
    pub(crate) fn stale(text: impl Into<String>, help: impl Into<String>) -> Self {
        Self { stale: true, ..Self::new(text, help) }
    }
}

impl From<bica_link::Error> for Failed {
    fn from(error: bica_link::Error) -> Self {
        let entry = match &error {
            bica_link::Error::Refused { entry, .. } => Some(*entry),
            bica_link::Error::Unknown(invalid) => invalid.entry,
            _ => None,
        };
        Self { entry, ..Self::new(error.to_string(), error.help()) }
    }
}

impl From<Invalid> for Failed {
    fn from(Invalid { what, help, entry }: Invalid) -> Self {
        Self { entry, ..Self::new(what, help) }
    }
}

/// Returns the error of an index that the description does not have.
pub(super) fn unknown(what: &str, index: usize) -> Failed {
    Failed::new(format!("there is no {what} {index}"), "the tree may have changed: reload the page")
}
