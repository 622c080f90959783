//! Activation trees of a file.

use serde::Serialize;

/// An `activation_tree!` outside of other macros.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tree {
    /// Name of the struct.
    pub name: String,
    /// The components, in the order of the list.
    pub members: Vec<Member>,
    /// The roles, in the order of the list.
    pub roles: Vec<Provided>,
}

/// A component of a tree.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Member {
    /// Name of its own in the tree.
    pub name: Option<String>,
    /// Its type, as written.
    pub ty: String,
}

/// A role of a tree.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Provided {
    /// The role, as written.
    pub role: String,
    /// Type of the component that provides it, as written.
    pub provider: String,
}
