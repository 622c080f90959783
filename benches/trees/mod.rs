//! Trees that do next to nothing: what is measured on them is the framework.

#[macro_use]
mod links;

pub(crate) mod chain;
pub(crate) mod latent;
pub(crate) mod machine;
pub(crate) mod shared;
pub(crate) mod switch;
pub(crate) mod wide;
