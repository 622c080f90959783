//! The fields of an activation tree.

pub(crate) mod check;
mod fields;
pub(crate) mod model;
pub(crate) mod parse;
