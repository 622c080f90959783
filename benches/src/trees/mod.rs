//! Trees that do next to nothing: what is measured on them is the framework.

#[macro_use]
mod links;

pub mod chain;
pub mod latent;
pub mod machine;
pub mod shared;
pub mod switch;
pub mod tuned;
pub mod wide;
