//! Codes of the mistakes that a tool can mend.

use std::fmt;

use crate::wording;

/// A mistake that a tool can mend, with the names that it needs. Its text is the message.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[expect(
    missing_docs,
    reason = "`found` is the name as written, `meant` the one that was probably meant, `known` a list of all, `word` that of the state"
)]
pub enum Code {
    /// An attribute is spelt like one of ours.
    MisspeltAttribute { found: String, meant: String },
    /// An option, a field or a key has another name.
    UnknownKey { found: String, meant: Option<String>, known: &'static str },
    /// No state has this name.
    UnknownState { found: String, meant: Option<String>, known: String },
    /// No state is marked as the initial one; the first state may be meant.
    NoInitial { first: String },
    /// No transition leads to a state.
    Unreachable { state: String },
    /// No transition leaves a state that is not marked as last.
    DeadEnd { state: String },
    /// A transition leaves a state that is marked as last.
    LastButLeft { state: String, word: &'static str },
}

impl Code {
    pub(crate) fn unknown_key(found: impl Into<String>, meant: Option<&str>, known: &'static str) -> Self {
        Self::UnknownKey { found: found.into(), meant: meant.map(str::to_owned), known }
    }

    /// Returns the text to write in place of the wrong one.
    #[must_use]
    pub fn meant(&self) -> Option<&str> {
        match self {
            Self::MisspeltAttribute { meant, .. } => Some(meant),
            Self::UnknownKey { meant, .. } | Self::UnknownState { meant, .. } => meant.as_deref(),
            _ => None,
        }
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&match self {
            Self::MisspeltAttribute { found, meant } => wording::misspelt_attribute(found, meant),
            Self::UnknownKey { found, meant, known } => wording::unknown_key(found, meant.as_deref(), known),
            Self::UnknownState { found, meant, known } => wording::unknown_state(found, meant.as_deref(), known),
            Self::NoInitial { first } => wording::no_initial(first),
            Self::Unreachable { state } => wording::unreachable(state),
            Self::DeadEnd { state } => wording::dead_end(state),
            Self::LastButLeft { state, word } => wording::last_but_left(state, word),
        })
    }
}
