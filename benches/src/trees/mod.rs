//! Trees of components with minimal work, so that the cost of the framework dominates.

#[macro_use]
mod links;

pub mod chain;
pub mod latent;
pub mod machine;
pub mod one;
pub mod shared;
pub mod switch;
pub mod tuned;
pub mod wide;
