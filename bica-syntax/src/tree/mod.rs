//! The fields of an activation tree.

pub mod check;
mod fields;
pub mod model;
mod names;
pub mod parse;
