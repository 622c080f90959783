//! Limits of requests.

use serde::Serialize;

use super::Failed;

/// Limits of the server. The page shows them during input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Limits {
    /// Number of open sessions.
    pub sessions: usize,
    /// Length of a note, characters.
    pub note: usize,
    /// Length of the name of a recording or a layout, characters.
    pub name: usize,
}

/// The limits.
pub const LIMITS: Limits = Limits { sessions: 16, note: 500, name: 100 };

/// Checks the length of a text, characters.
///
/// # Errors
/// If it is too long.
pub(crate) fn check_length(what: &str, text: &str, limit: usize) -> Result<(), Failed> {
    let length = text.chars().count();
    let long = || Failed::new(format!("{what} has {length} characters"), format!("write at most {limit}"));
    (length <= limit).then_some(()).ok_or_else(long)
}
