//! The impl block of a component.

mod arguments;
mod attributes;
pub(crate) mod block;
pub(crate) mod check;
pub(crate) mod links;
pub(crate) mod model;
mod near_miss;
mod operator;
mod options;
pub(crate) mod parse;
mod resolve;
mod signature;
