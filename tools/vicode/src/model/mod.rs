//! Content of a source file, each part with its span.
//!
//! The model is a view: it is derived from the text, and edits change the text. It serialises to JSON; `docs/vicode.md` has the
//! schema.

mod component;
mod function;
mod params;
mod resolved;
mod span;
mod table;
mod tree;

use bica_syntax::code::Code;
use serde::Serialize;

pub use self::component::{
    Arrow, Component, Hook, HookRole, Modulation, Options, Output, Setting, Sources, State, Transition, Work,
};
pub use self::function::{Argument, Docs, Function, Input, LinkKind};
pub use self::params::{Key, Parameter, ParameterGroup};
pub use self::resolved::Link;
pub(crate) use self::resolved::links;
pub use self::span::{Name, Span};
pub use self::table::{Cell, Row, Table};
pub use self::tree::{Member, Provided, Tree};

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
    /// Trees that an `activation_tree!` outside of other macros declares, in the order of the text.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub trees: Vec<Tree>,
    /// Mistakes, in the order of the text.
    pub problems: Vec<Problem>,
}

/// A mistake.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Problem {
    /// Wrong part of the text.
    pub span: Span,
    /// Message with the remedy.
    pub message: String,
    /// Reporter.
    pub from: Reporter,
    /// Code of the mistake, if a fix is known.
    #[serde(skip)]
    pub code: Option<Code>,
}

impl Problem {
    /// Creates a syntax error.
    pub(crate) const fn syntax(span: Span, message: String) -> Self {
        Self { span, message, from: Reporter::Syntax, code: None }
    }
}

/// Reporter of a mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Reporter {
    /// The parser of Rust.
    Syntax,
    /// The macros of BICA.
    Macro,
}

impl Model {
    /// Returns the component with that key, or the only one with that name.
    #[must_use]
    pub fn component(&self, key: &str) -> Option<&Component> {
        let mut named = self.components.iter().filter(|component| component.name.text == key);
        let of_key = self.components.iter().find(|component| component.key == key);
        of_key.or_else(|| named.next().filter(|_| named.next().is_none()))
    }

    /// Returns the struct of parameters with that name.
    #[must_use]
    pub fn group(&self, name: &str) -> Option<&ParameterGroup> {
        self.parameters.iter().find(|group| group.name.text == name)
    }
}
