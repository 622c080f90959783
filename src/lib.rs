//! Placeholder
#![no_std]

#[doc(hidden)]
pub use bica_core::__private;
pub use bica_core::*;
pub use bica_macros::{activation_tree, component};

/// Everything that a file of components needs.
pub mod prelude {
    pub use bica_core::{Component, ComponentId, Duration, Has, Hold, Instant, Probe, Rate, Time, Tree};
    pub use bica_macros::{activation_tree, component};
}
