//! Worlds that a page can open.

use serde::Serialize;

/// A world that the program can simulate.
#[derive(Clone, Debug, Serialize)]
pub struct World {
    /// Name.
    pub name: String,
    /// Options besides the seed.
    pub options: Vec<WorldOption>,
}

/// An option of a world that the page offers: a whole number from 0 on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct WorldOption {
    /// Name.
    pub name: String,
    /// Description, for people.
    pub doc: String,
    /// Largest value.
    pub max: u64,
}
