//! Colours of the goals.

use core::fmt;

/// Colour of a goal.
///
/// The team that defends the yellow goal plays in red, the other in blue (SPL rules of 2009).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "postcard-schema", derive(postcard_schema::Schema))]
pub enum GoalColour {
    /// Yellow.
    Yellow,
    /// Sky-blue.
    SkyBlue,
}

impl GoalColour {
    /// Returns the colour of the other goal.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Yellow => Self::SkyBlue,
            Self::SkyBlue => Self::Yellow,
        }
    }
}

impl fmt::Display for GoalColour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Yellow => "yellow",
            Self::SkyBlue => "sky-blue",
        })
    }
}
