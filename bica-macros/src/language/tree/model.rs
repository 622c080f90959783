//! The content of a tree.

use proc_macro2::Ident;
use syn::{Attribute, Expr, Path, Type, Visibility};

/// A tree as written.
pub(crate) struct Draft {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
    pub(crate) root: Option<Type>,
    pub(crate) cycle_hz: Option<f32>,
    pub(crate) budget_ms: Option<f32>,
    /// The word `tunable` stands among the fields.
    pub(crate) tunable: bool,
    pub(crate) components: Option<Vec<Entry>>,
    /// The crate that generated code uses.
    pub(crate) krate: Path,
}

/// A tree without mistakes in its text.
pub(crate) struct Tree {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
    /// The root as written, which may be another path to a type of the list.
    pub(crate) root: Type,
    pub(crate) cycle_hz: f32,
    pub(crate) budget_ms: Option<f32>,
    /// The word `tunable` stands among the fields.
    pub(crate) tunable: bool,
    pub(crate) components: Vec<Entry>,
    pub(crate) krate: Path,
}

/// A component in the list.
#[derive(Clone)]
pub(crate) struct Entry {
    pub(crate) kind: Type,
    /// The initial value, if not `new()`.
    pub(crate) value: Option<Expr>,
}
