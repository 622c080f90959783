//! The fields of an activation tree.

pub mod check;
mod fields;
pub mod model;
pub mod parse;
