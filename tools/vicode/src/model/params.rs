//! Structs of parameters.

use serde::Serialize;

use super::{Docs, Name, Span};

/// A struct with `#[derive(Params)]`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ParameterGroup {
    /// Its name.
    pub name: Name,
    /// The struct with its attributes.
    pub span: Span,
    /// Its doc comment.
    pub docs: Docs,
    /// Its fields, in the order of the text.
    pub parameters: Vec<Parameter>,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Parameter {
    /// Its name.
    pub name: Name,
    /// The field with its attributes.
    pub span: Span,
    /// Its doc comment.
    pub docs: Docs,
    /// Type as written.
    pub ty: Name,
    /// `default`, `range`, `unit`, `step`, in the order of the text.
    pub keys: Vec<Key>,
}

impl Parameter {
    /// Returns the value of a key as written.
    #[must_use]
    pub fn value(&self, key: &str) -> Option<&Name> {
        self.keys.iter().find(|one| one.key.text == key)?.value.as_ref()
    }
}

/// A key of `#[param(...)]`.
pub type Key = super::Setting;
