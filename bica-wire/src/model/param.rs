//! Parameters, and arguments of modulations and actions.

use std::borrow::ToOwned;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use bica_core::Value;
use bica_core::params;
use bica_core::refusal::Reason;
use serde::{Deserialize, Serialize};

use super::{Invalid, Place, Plain};

/// Kind and range of a parameter.
pub type Kind = params::Kind<Variants>;

/// The variants of an enum.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Variants(pub Vec<Variant>);

/// A variant of an enum.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Variant {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
}

impl params::Variants for Variants {
    fn count(&self) -> usize {
        self.0.len()
    }

    fn name(&self, index: usize) -> Option<&str> {
        self.0.get(index).map(|variant| variant.name.as_str())
    }
}

/// A parameter, or an argument of a modulation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Flat", into = "Flat")]
pub struct Param {
    /// Name of the struct that contains it; empty for an argument.
    pub group: String,
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Unit.
    pub unit: Option<String>,
    /// Kind and range.
    pub kind: Kind,
    /// Default value.
    pub default: Value,
    /// Place from which a tool may take the value of an argument.
    pub place: Option<Place>,
    /// Current value of a parameter.
    pub value: Option<Value>,
}

impl Param {
    /// Returns the current value; the default as long as the current one is unknown.
    #[must_use]
    pub fn current(&self) -> Value {
        self.value.unwrap_or(self.default)
    }

    /// Parses a value of this parameter: a number, `true`, `false`, or the name of a variant.
    ///
    /// # Errors
    /// If the text is no value of this kind, or out of range.
    pub fn parse(&self, text: &str) -> Result<Value, Invalid> {
        self.kind.parse(text).map_err(|reason| self.refuse(text, reason))
    }

    /// Converts a value as JSON or TOML contains it.
    ///
    /// # Errors
    /// If it is of another kind, or out of range.
    pub fn value_of(&self, plain: &Plain) -> Result<Value, Invalid> {
        let value = plain.value(&self.kind).and_then(|value| self.kind.accepts(value).map(|()| value));
        value.map_err(|reason| self.refuse(&plain.to_string(), reason))
    }

    /// Returns a value as JSON and TOML contain it.
    #[must_use]
    pub fn plain(&self, value: Value) -> Plain {
        Plain::new(value, &self.kind)
    }

    /// Returns the range of a parameter as text: `0.0 to 1.0`, `true, false`, or the names of the variants.
    #[must_use]
    pub fn range(&self) -> String {
        match &self.kind {
            Kind::F32 { min, max, .. } => format!("{min:?} to {max:?}"),
            Kind::I32 { min, max, .. } => format!("{min} to {max}"),
            Kind::U32 { min, max, .. } => format!("{min} to {max}"),
            Kind::Bool => "true, false".to_owned(),
            Kind::Choice { variants: Variants(list) } => {
                list.iter().map(|variant| variant.name.as_str()).collect::<Vec<_>>().join(", ")
            }
        }
    }

    /// Returns the error for a value that the kind refuses.
    #[must_use]
    pub fn refuse(&self, text: &str, reason: Reason) -> Invalid {
        let unit = self.unit.as_deref().map(|unit| format!(" {unit}")).unwrap_or_default();
        let values = self.range();
        let help = match self.kind {
            Kind::F32 { .. } => format!("write a number from {values}{unit}"),
            Kind::I32 { .. } | Kind::U32 { .. } => format!("write a whole number from {values}{unit}"),
            Kind::Choice { .. } => format!("write one of {values}"),
            Kind::Bool => "write true or false".to_owned(),
        };
        let what = match reason {
            Reason::UnknownVariant { .. } => "there is no such variant".to_owned(),
            Reason::WrongKind { expected, .. } => format!("expected {expected}"),
            reason => reason.to_string(),
        };
        Invalid::new(format!("`{text}` is not a value of `{}`: {what}", self.name), help)
    }
}

/// A parameter in JSON, where the kind decides which fields are present and what a value is.
#[derive(Serialize, Deserialize)]
struct Flat {
    #[serde(default, skip_serializing_if = "String::is_empty")]
    group: String,
    name: String,
    doc: String,
    unit: Option<String>,
    kind: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    min: Option<Plain>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    max: Option<Plain>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    step: Option<Plain>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    variants: Option<Variants>,
    default: Plain,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    place: Option<Place>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    value: Option<Plain>,
}

impl From<Param> for Flat {
    fn from(param: Param) -> Self {
        let (default, value) = (param.plain(param.default), param.value.map(|value| param.plain(value)));
        let kind = param.kind.name().to_owned();
        let (min, max, step, variants) = match param.kind {
            Kind::F32 { min, max, step } => (Some(Value::F32(min)), Some(Value::F32(max)), step.map(Value::F32), None),
            Kind::I32 { min, max, step } => (Some(Value::I32(min)), Some(Value::I32(max)), step.map(Value::I32), None),
            Kind::U32 { min, max, step } => (Some(Value::U32(min)), Some(Value::U32(max)), step.map(Value::U32), None),
            Kind::Bool => (None, None, None, None),
            Kind::Choice { variants } => (None, None, None, Some(variants)),
        };
        let [min, max, step] = [min, max, step].map(|value| value.map(Plain::from));
        let Param { group, name, doc, unit, place, .. } = param;
        Self { group, name, doc, unit, kind, min, max, step, variants, default, place, value }
    }
}

impl TryFrom<Flat> for Param {
    type Error = String;

    fn try_from(flat: Flat) -> Result<Self, String> {
        let wrong = |what: &str| format!("the parameter `{}` has a wrong {what}", flat.name);
        let kind = flat.kind().ok_or_else(|| wrong("kind or range"))?;
        let value = |plain: &Plain| plain.value(&kind).map_err(|_| wrong("value"));
        let (default, value) = (value(&flat.default)?, flat.value.as_ref().map(value).transpose()?);
        let Flat { group, name, doc, unit, place, .. } = flat;
        Ok(Self { group, name, doc, unit, kind, default, place, value })
    }
}

impl Flat {
    fn kind(&self) -> Option<Kind> {
        Some(match self.kind.as_str() {
            "f32" => self.range(Plain::float).map(|(min, max, step)| Kind::F32 { min, max, step })?,
            "i32" => self.range(Plain::integer).map(|(min, max, step)| Kind::I32 { min, max, step })?,
            "u32" => self.range(Plain::integer).map(|(min, max, step)| Kind::U32 { min, max, step })?,
            "bool" => Kind::Bool,
            "choice" => Kind::Choice { variants: self.variants.clone()? },
            _ => return None,
        })
    }

    /// Returns the smallest and the largest value and the step.
    fn range<T>(&self, read: impl Fn(&Plain) -> Option<T>) -> Option<(T, T, Option<T>)> {
        let step = self.step.as_ref().map(|step| read(step).ok_or(())).transpose().ok()?;
        Some((read(self.min.as_ref()?)?, read(self.max.as_ref()?)?, step))
    }
}
