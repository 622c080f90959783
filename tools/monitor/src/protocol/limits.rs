//! Limits of requests.

use serde::Serialize;

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
