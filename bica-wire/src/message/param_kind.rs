//! Kinds and values of parameters and arguments.

use bica_core::params;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// Value of a parameter, or of an argument of a modulation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum Value {
    /// A number.
    F32(f32),
    /// A whole number.
    I32(i32),
    /// A whole number that is not negative.
    U32(u32),
    /// On or off.
    Bool(bool),
    /// Index of a variant of an enum.
    Choice(u32),
}

impl Value {
    /// Returns the value in a message; `None` for a kind that this version of the protocol does not know.
    #[must_use]
    pub const fn of(value: params::Value) -> Option<Self> {
        Some(match value {
            params::Value::F32(value) => Self::F32(value),
            params::Value::I32(value) => Self::I32(value),
            params::Value::U32(value) => Self::U32(value),
            params::Value::Bool(value) => Self::Bool(value),
            params::Value::Choice(value) => Self::Choice(value),
            _ => return None,
        })
    }
}

impl From<Value> for params::Value {
    fn from(value: Value) -> Self {
        match value {
            Value::F32(value) => Self::F32(value),
            Value::I32(value) => Self::I32(value),
            Value::U32(value) => Self::U32(value),
            Value::Bool(value) => Self::Bool(value),
            Value::Choice(value) => Self::Choice(value),
        }
    }
}

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
