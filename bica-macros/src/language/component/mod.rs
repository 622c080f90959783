//! The impl block of a component.

mod arguments;
mod attributes;
pub(crate) mod check;
pub(crate) mod links;
pub(crate) mod model;
mod options;
pub(crate) mod parse;
mod resolve;
mod signature;
