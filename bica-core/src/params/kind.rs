//! Kinds of parameters, and values.

use core::fmt;

use super::refusal::Reason;

/// Value of a parameter, or of an argument of a modulation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
pub enum Value {
    /// A number.
    F32(f32),
    /// A whole number.
    I32(i32),
    /// A whole number that is not negative.
    U32(u32),
    /// On or off.
    Bool(bool),
    /// A variant of an enum: its index in [`Kind::Choice`].
    Choice(u32),
}

impl Value {
    /// The name of the kind, as [`Kind::name`].
    #[must_use]
    pub const fn kind_name(&self) -> &'static str {
        match self {
            Self::F32(_) => "f32",
            Self::I32(_) => "i32",
            Self::U32(_) => "u32",
            Self::Bool(_) => "bool",
            Self::Choice(_) => "choice",
        }
    }
}

/// The number, the word, or the index of the variant.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::F32(value) => value.fmt(f),
            Self::I32(value) => value.fmt(f),
            Self::U32(value) | Self::Choice(value) => value.fmt(f),
            Self::Bool(value) => value.fmt(f),
        }
    }
}

/// Kind of a parameter, with the values that it can have. `V` tells the variants of an enum: in a tree's description all of them, in a
/// message their number, in a tool's model texts that it owns.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
pub enum Kind<V = &'static [Variant]> {
    /// A finite number.
    F32 {
        /// Smallest value.
        min: f32,
        /// Largest value.
        max: f32,
        /// Step that a tool offers; values between two steps are valid.
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
        /// The variants.
        variants: V,
    },
}

/// A variant of an enum that is a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// The variant's name.
    pub name: &'static str,
    /// The variant's doc comment; may be empty.
    pub doc: &'static str,
}

/// The variants of an enum, in the order of their indices.
pub trait Variants {
    /// Number of variants.
    fn count(&self) -> usize;

    /// Returns the name of the variant at `index`.
    fn name(&self, index: usize) -> Option<&str>;
}

impl Variants for &'static [Variant] {
    fn count(&self) -> usize {
        self.len()
    }

    fn name(&self, index: usize) -> Option<&str> {
        self.get(index).map(|variant| variant.name)
    }
}

impl<V> Kind<V> {
    /// `"f32"`, `"i32"`, `"u32"`, `"bool"` or `"choice"`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::F32 { .. } => "f32",
            Self::I32 { .. } => "i32",
            Self::U32 { .. } => "u32",
            Self::Bool => "bool",
            Self::Choice { .. } => "choice",
        }
    }

    /// Returns the kind with another form of its variants.
    #[must_use]
    pub fn map<W>(&self, variants: impl FnOnce(&V) -> W) -> Kind<W> {
        match self {
            &Self::F32 { min, max, step } => Kind::F32 { min, max, step },
            &Self::I32 { min, max, step } => Kind::I32 { min, max, step },
            &Self::U32 { min, max, step } => Kind::U32 { min, max, step },
            Self::Bool => Kind::Bool,
            Self::Choice { variants: of } => Kind::Choice { variants: variants(of) },
        }
    }
}

impl<V: Variants> Kind<V> {
    /// Checks that a value is of this kind, finite and in range.
    ///
    /// # Errors
    /// The reason why it is not.
    pub fn accepts(&self, value: Value) -> Result<(), Reason> {
        let range = |min, max| Err(Reason::OutOfRange { value, min, max });
        match (self, value) {
            (Self::F32 { .. }, Value::F32(number)) if !number.is_finite() => Err(Reason::NotFinite),
            (&Self::F32 { min, max, .. }, Value::F32(number)) if number < min || number > max => {
                range(Value::F32(min), Value::F32(max))
            }
            (&Self::I32 { min, max, .. }, Value::I32(number)) if number < min || number > max => {
                range(Value::I32(min), Value::I32(max))
            }
            (&Self::U32 { min, max, .. }, Value::U32(number)) if number < min || number > max => {
                range(Value::U32(min), Value::U32(max))
            }
            (Self::Choice { variants }, Value::Choice(index)) if index as usize >= variants.count() => {
                Err(Reason::UnknownVariant { count: variants.count() })
            }
            (Self::F32 { .. }, Value::F32(_))
            | (Self::I32 { .. }, Value::I32(_))
            | (Self::U32 { .. }, Value::U32(_))
            | (Self::Bool, Value::Bool(_))
            | (Self::Choice { .. }, Value::Choice(_)) => Ok(()),
            _ => Err(Reason::WrongKind { expected: self.name(), found: value.kind_name() }),
        }
    }
}
