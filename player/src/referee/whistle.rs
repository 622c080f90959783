//! The referee's whistle.

use bica::prelude::*;

/// Whether the whistle for the kick-off was heard. The `GameController` shows the state playing up to 10 s later.
///
/// No component listens to microphones: an operator, or a component to come, calls `hear`.
#[derive(Clone, Copy, Debug)]
pub struct Whistle {
    heard: bool,
}

#[component(budget_us = 1)]
impl Whistle {
    /// Creates the component before a whistle.
    #[must_use]
    pub const fn new() -> Self {
        Self { heard: false }
    }

    /// Notes that the whistle was heard. It counts in the state set only.
    #[modulation]
    pub const fn hear(&mut self) {
        self.heard = true;
    }

    /// Forgets the whistle: another state than set is shown.
    pub const fn forget(&mut self) {
        self.heard = false;
    }

    /// Whether the whistle was heard since the state became set.
    #[output]
    #[must_use]
    pub const fn heard(&self) -> bool {
        self.heard
    }
}
