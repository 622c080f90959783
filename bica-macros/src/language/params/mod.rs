//! Structs of parameters, and enums that are parameters.

pub(crate) mod field;
pub(crate) mod model;
pub(crate) mod parse;
