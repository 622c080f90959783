//! Kinds of parameters and arguments.

use bica_core::params;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// Kind of a parameter or argument, with the values that it can have.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum ParamKind {
    /// A finite number.
    F32 {
        /// Smallest value.
        min: f32,
        /// Largest value.
        max: f32,
        /// Step that a tool offers.
        step: Option<f32>,
    },
    /// A whole number.
    I32 {
        /// Smallest value.
        min: i32,
        /// Largest value.
        max: i32,
        /// Step that a tool offers.
        step: Option<i32>,
    },
    /// A whole number that is not negative.
    U32 {
        /// Smallest value.
        min: u32,
        /// Largest value.
        max: u32,
        /// Step that a tool offers.
        step: Option<u32>,
    },
    /// On or off.
    Bool,
    /// One variant of an enum.
    Choice {
        /// Number of variants.
        variants: u16,
    },
    /// A kind that this version of the protocol does not know.
    Unknown,
}

impl ParamKind {
    /// Returns the kind in a message.
    #[must_use]
    pub const fn of(kind: &params::Kind) -> Self {
        match *kind {
            params::Kind::F32 { min, max, step } => Self::F32 { min, max, step },
            params::Kind::I32 { min, max, step } => Self::I32 { min, max, step },
            params::Kind::U32 { min, max, step } => Self::U32 { min, max, step },
            params::Kind::Bool => Self::Bool,
            params::Kind::Choice { variants } => Self::Choice { variants: variants.len() as u16 },
            _ => Self::Unknown,
        }
    }
}
