//! Values as text, for command lines and files.

use core::fmt;

use super::refusal::Reason;
use super::{Kind, Value, Variants};

impl<V: Variants> Kind<V> {
    /// Reads a value: a number, `true` or `false`, or the name of a variant.
    ///
    /// ```
    /// use bica_core::Value;
    /// use bica_core::params::Kind;
    ///
    /// let kind: Kind = Kind::F32 { min: 0.0, max: 1.0, step: None };
    /// assert_eq!(kind.parse("0.5"), Ok(Value::F32(0.5)));
    /// assert!(kind.parse("1.5").is_err());
    /// ```
    ///
    /// # Errors
    /// If the text is no value of this kind, or the value is not finite or out of range.
    pub fn parse(&self, text: &str) -> Result<Value, Reason> {
        let wrong = Reason::WrongKind { expected: self.name(), found: "text" };
        let value = match self {
            Self::F32 { .. } => Value::F32(text.parse().map_err(|_| wrong)?),
            Self::I32 { .. } => Value::I32(text.parse().map_err(|_| wrong)?),
            Self::U32 { .. } => Value::U32(text.parse().map_err(|_| wrong)?),
            Self::Bool => Value::Bool(text.parse().map_err(|_| wrong)?),
            Self::Choice { variants } => {
                let index = (0..variants.count()).find(|&index| variants.name(index) == Some(text));
                Value::Choice(index.ok_or(Reason::UnknownVariant { count: variants.count() })? as u32)
            }
        };
        self.accepts(value).map(|()| value)
    }

    /// Returns the text of a value, which [`parse`](Self::parse) reads as the same value.
    ///
    /// A number with a decimal point has one also if it is whole, and a variant is its name.
    #[must_use]
    pub const fn text(&self, value: Value) -> ValueText<'_, V> {
        ValueText { kind: self, value }
    }
}

/// A value that prints as text; see [`Kind::text`].
#[derive(Clone, Copy, Debug)]
pub struct ValueText<'a, V> {
    kind: &'a Kind<V>,
    value: Value,
}

impl<V: Variants> fmt::Display for ValueText<'_, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.kind, self.value) {
            (Kind::Choice { variants }, Value::Choice(index)) => match variants.name(index as usize) {
                Some(name) => f.pad(name),
                None => self.value.fmt(f),
            },
            // The shortest digits that give the same number, with a point.
            (_, Value::F32(value)) => write!(f, "{value:?}"),
            (_, value) => value.fmt(f),
        }
    }
}
