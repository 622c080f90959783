//! What `Goalkeeper` does.

use bica::prelude::*;

/// What `Goalkeeper` does.
#[derive(Debug)]
pub struct Goalkeeper;

#[component]
impl Goalkeeper {
    /// Creates the component.
    #[must_use]
    pub const fn new() -> Self {
        Self
    }

    /// What it does first.
    #[state(initial, last)]
    fn begin(&mut self) {}
}
