//! What a transition waits for: a time, and the result of a child.

use std::fmt;

use proc_macro2::Ident;
use syn::Type;

use crate::text;

/// What a transition waits for beside its condition.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Guard {
    /// Least time in the state before it.
    pub timer: Option<Timer>,
    /// The result of a child.
    pub when: Option<When>,
    /// How often it is taken in a row, 1 to 126.
    pub times: Option<u8>,
    /// Whether the attribute stands on the state that it leaves, so that no function decides.
    pub bare: bool,
}

impl Guard {
    /// Whether the transition waits for nothing.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.timer.is_none() && self.when.is_none() && self.times.is_none()
    }
}

/// Least time in a state before a transition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Timer {
    /// A constant, ms.
    Ms(u32),
    /// A parameter of the component.
    Parameter(Box<Parameter>),
}

/// `Approach::patience`: a field of a struct of parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// The struct.
    pub of: TypeText,
    /// The field.
    pub field: Ident,
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}::{}", text::written(&self.of.0), text::name(&self.field))
    }
}

/// `done(Reach)`: a child has ended with a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct When {
    /// The result.
    pub end: End,
    /// The child.
    pub child: TypeText,
}

impl fmt::Display for When {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}({})", self.end.word(), text::written(&self.child.0))
    }
}

/// The result with which a machine ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// It has done its work.
    Done,
    /// It could not.
    Failed,
}

impl End {
    /// The word in the source.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Failed => "failed",
        }
    }

    /// The word for what other frameworks call otherwise.
    pub(super) fn meant(written: &str) -> Option<&'static str> {
        match written {
            "success" | "succeeded" | "ok" | "finished" => Some("done"),
            "failure" | "error" | "err" => Some("failed"),
            _ => None,
        }
    }
}

/// A type that is compared by its text.
#[derive(Clone)]
pub struct TypeText(pub Type);

impl PartialEq for TypeText {
    fn eq(&self, other: &Self) -> bool {
        text::written(&self.0) == text::written(&other.0)
    }
}

impl Eq for TypeText {}

impl fmt::Debug for TypeText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&text::written(&self.0))
    }
}
