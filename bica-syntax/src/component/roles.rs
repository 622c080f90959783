//! The attributes that assign a function its role.

use proc_macro2::{Group, TokenTree};
use syn::Attribute;

/// The attributes that assign a function its role.
pub(super) const ROLES: [&str; 10] =
    ["state", "transition", "entry", "exit", "before", "start", "stop", "output", "modulation", "work"];

/// The role that an attribute assigns, if it is one of ours.
#[must_use]
pub fn role(attribute: &Attribute) -> Option<&'static str> {
    ROLES.into_iter().find(|role| attribute.path().is_ident(role))
}

/// Whether the brackets of an attribute begin with one of our names.
pub(super) fn begins_with_role(brackets: &Group) -> bool {
    matches!(brackets.stream().into_iter().next(), Some(TokenTree::Ident(name)) if ROLES.iter().any(|role| name == role))
}
