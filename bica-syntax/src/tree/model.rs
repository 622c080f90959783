//! The content of a tree.

use proc_macro2::Ident;
use syn::{Attribute, Expr, Path, Type, Visibility};

use crate::text;

/// A tree as written.
pub struct Draft {
    /// Attributes of the struct.
    pub attributes: Vec<Attribute>,
    /// Visibility of the struct.
    pub visibility: Visibility,
    /// Name of the struct.
    pub name: Ident,
    /// Root.
    pub root: Option<Type>,
    /// Cycles per second, Hz.
    pub cycle_hz: Option<f32>,
    /// Longest time of one cycle, ms.
    pub budget_ms: Option<f32>,
    /// The word `tunable` stands among the fields.
    pub tunable: bool,
    /// Components in the order of the text.
    pub components: Option<Vec<Entry>>,
    /// Roles in the order of the text.
    pub roles: Vec<RoleEntry>,
    /// The crate that generated code uses.
    pub krate: Path,
}

impl Draft {
    /// Whether the root has the name of the tree: then this is the name of a component, and no struct can have it.
    #[must_use]
    pub fn names_a_component(&self) -> bool {
        self.root.as_ref().is_some_and(|root| self.name == text::written(root))
    }
}

/// A tree without mistakes in its text.
pub struct Tree {
    /// Attributes of the struct.
    pub attributes: Vec<Attribute>,
    /// Visibility of the struct.
    pub visibility: Visibility,
    /// Name of the struct.
    pub name: Ident,
    /// The root as written, which may be another path to a type of the list.
    pub root: Type,
    /// Cycles per second, Hz.
    pub cycle_hz: f32,
    /// Longest time of one cycle, ms.
    pub budget_ms: Option<f32>,
    /// The word `tunable` stands among the fields.
    pub tunable: bool,
    /// Components in the order of the text.
    pub components: Vec<Entry>,
    /// Roles in the order of the text.
    pub roles: Vec<RoleEntry>,
    /// The crate that generated code uses.
    pub krate: Path,
}

/// A role and the component that provides it.
#[derive(Clone)]
pub struct RoleEntry {
    /// The trait.
    pub role: Path,
    /// Type of the component as written, which may be another path to a type of the list.
    pub provider: Type,
}

/// A component in the list.
#[derive(Clone)]
pub struct Entry {
    /// Name in this tree, if it is not the type.
    pub name: Option<Ident>,
    /// Type of the component.
    pub kind: Type,
    /// The initial value, if not `new()`.
    pub value: Option<Expr>,
}

impl Entry {
    /// What tools call the component: its name in this tree, or the type as written.
    #[must_use]
    pub fn label(&self) -> String {
        self.name.as_ref().map_or_else(|| text::written(&self.kind), text::name)
    }
}
