//! What a source file holds, each part with its place in the text.
//!
//! The model is a view: it is read from the text, and edits change the text. It serialises to JSON; `docs/vicode.md` has the
//! schema.

mod component;
mod function;
mod graph;
mod params;
mod span;
mod table;

use serde::Serialize;

pub use self::component::{
    Arrow, Component, Hook, HookRole, Info, Modulation, Options, Setting, Sources, State, Transition,
};
pub use self::function::{Argument, Docs, Function, Input, LinkKind};
pub(crate) use self::graph::own_links;
pub use self::graph::{Edge, Graph, Link};
pub use self::params::{Key, Parameter, ParameterGroup};
pub use self::span::{Name, Span};
pub use self::table::{Cell, Row, Table};

/// A file.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Model {
    /// Impl blocks with `#[component]`, in the order of the text.
    pub components: Vec<Component>,
    /// Structs with `#[derive(Params)]`, in the order of the text.
    pub parameters: Vec<ParameterGroup>,
    /// Constants that are tables of numbers, in the order of the text.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tables: Vec<Table>,
    /// What is wrong, in the order of the text.
    pub problems: Vec<Problem>,
}

/// A mistake.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Problem {
    /// The wrong part of the text.
    pub span: Span,
    /// What is wrong and how to mend it.
    pub message: String,
    /// Who reports it.
    pub from: Reporter,
}

/// Who reports a mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Reporter {
    /// The text is no Rust.
    Syntax,
    /// The macros of BICA would report the same.
    Macro,
}

impl Model {
    /// The component with that key, or the only one of that name.
    #[must_use]
    pub fn component(&self, key: &str) -> Option<&Component> {
        let mut named = self.components.iter().filter(|component| component.name.text == key);
        let of_key = self.components.iter().find(|component| component.key == key);
        of_key.or_else(|| named.next().filter(|_| named.next().is_none()))
    }

    /// The struct of parameters of that name.
    #[must_use]
    pub fn group(&self, name: &str) -> Option<&ParameterGroup> {
        self.parameters.iter().find(|group| group.name.text == name)
    }
}
