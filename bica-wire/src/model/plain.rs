//! Values as JSON and TOML write them.

use core::fmt;
use std::borrow::ToOwned;
use std::string::{String, ToString};

use bica_core::Value;
use bica_core::params::{Kind, Variants};
use bica_core::refusal::Reason;
use serde::{Deserialize, Serialize};

/// A value without its kind: a number, `true` or `false`, or the name of a variant.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Plain {
    /// On or off.
    Bool(bool),
    /// A whole number.
    Integer(i64),
    /// A number.
    Number(f64),
    /// The name of a variant, or any value as text.
    Name(String),
}

impl Plain {
    /// Returns the plain form of a value of a kind. A variant without a name is its index.
    #[must_use]
    pub fn new<V: Variants>(value: Value, kind: &Kind<V>) -> Self {
        match (value, kind) {
            (Value::Choice(index), Kind::Choice { variants }) => {
                variants.name(index as usize).map_or(Self::Integer(index.into()), |name| Self::Name(name.to_owned()))
            }
            (value, _) => Self::from(value),
        }
    }

    /// Returns the value of a kind, without a check of a number's range. A text is read as [`Kind::parse`] reads it.
    ///
    /// # Errors
    /// If it is no value of this kind.
    pub fn value<V: Variants>(&self, kind: &Kind<V>) -> Result<Value, Reason> {
        let value = match (kind, self) {
            (_, Self::Name(text)) => return kind.parse(text),
            (Kind::F32 { .. }, _) => self.float().map(Value::F32),
            (Kind::I32 { .. }, _) => self.integer().map(Value::I32),
            (Kind::U32 { .. }, _) => self.integer().map(Value::U32),
            (Kind::Bool, &Self::Bool(is_on)) => Some(Value::Bool(is_on)),
            (Kind::Bool | Kind::Choice { .. }, _) => None,
        };
        value.ok_or(Reason::WrongKind { expected: kind.name(), found: self.name() })
    }

    pub(super) const fn float(&self) -> Option<f32> {
        match *self {
            Self::Number(number) => Some(number as f32),
            Self::Integer(number) => Some(number as f32),
            _ => None,
        }
    }

    pub(super) fn integer<T: TryFrom<i64>>(&self) -> Option<T> {
        if let Self::Integer(number) = *self { number.try_into().ok() } else { None }
    }

    const fn name(&self) -> &'static str {
        match self {
            Self::Bool(_) => "bool",
            Self::Integer(_) => "integer",
            Self::Number(_) => "number",
            Self::Name(_) => "text",
        }
    }
}

/// A variant becomes its index.
impl From<Value> for Plain {
    fn from(value: Value) -> Self {
        match value {
            // The shortest decimal text of the f32, not the exact value of its f64.
            Value::F32(number) => Self::Number(number.to_string().parse().unwrap_or_else(|_| number.into())),
            Value::I32(number) => Self::Integer(number.into()),
            Value::U32(number) | Value::Choice(number) => Self::Integer(number.into()),
            Value::Bool(is_on) => Self::Bool(is_on),
        }
    }
}

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool(is_on) => is_on.fmt(f),
            Self::Integer(number) => number.fmt(f),
            // 1e300 has 301 digits otherwise.
            Self::Number(number) if number.abs() >= 1e16 => write!(f, "{number:e}"),
            Self::Number(number) => number.fmt(f),
            Self::Name(name) => f.write_str(name),
        }
    }
}
