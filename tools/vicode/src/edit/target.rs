//! A component whose functions are searched, and the places found.

use serde::Serialize;

use crate::model::Span;

/// A place that uses, or may use, a function of a component.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Use {
    /// The name.
    pub span: Span,
    /// Whether the type before the name is certainly the component; false if the file alone does not decide.
    pub certain: bool,
}

/// Component whose functions are searched.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// Names of its type: its own, and aliases in its file.
    pub(super) names: Vec<String>,
    /// Modules of its file that contain it.
    pub(super) module: String,
    /// Whether other files have a component of that name, so that the name is ambiguous.
    pub(super) has_namesakes: bool,
}
