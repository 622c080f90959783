//! Structs of parameters, and enums that are parameters.

pub mod field;
pub mod model;
pub mod parse;
