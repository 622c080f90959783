//! The referee's whistle.

use bica::prelude::*;

/// The whistle as an operator reports it.
///
/// No component listens to microphones: one that does provides the role [`Ears`](crate::roles::Ears) in its tree instead.
#[derive(Clone, Copy, Debug)]
pub struct Whistle {
    reported: bool,
    heard: bool,
}

#[component(budget_us = 1)]
impl Whistle {
    /// Creates the component before a whistle.
    #[must_use]
    pub const fn new() -> Self {
        Self { reported: false, heard: false }
    }

    fn step(&mut self) {
        self.heard = core::mem::take(&mut self.reported);
    }

    /// Reports that the whistle was heard. It counts in the state set only.
    #[modulation]
    pub const fn hear(&mut self) {
        self.reported = true;
    }

    /// Whether the whistle was heard since the last cycle.
    #[output]
    #[must_use]
    pub const fn heard(&self) -> bool {
        self.heard
    }
}
