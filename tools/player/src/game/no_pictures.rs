//! Pictures and films in a program that was built without them.

use std::path::Path;

use bica_app::Failure;

use crate::game::observer::GameObserver;
use crate::play::built_without;

/// An album or a film, of which there is none.
#[derive(Debug)]
pub(crate) enum NoPictures {}

impl NoPictures {
    /// Refuses.
    pub(crate) fn new(_: &Path) -> Result<Self, Failure> {
        Err(built_without("evaluation", "pictures and films"))
    }

    pub(crate) const fn count(&self) -> usize {
        match *self {}
    }

    pub(crate) const fn finish(self) -> Result<usize, Failure> {
        match self {}
    }
}

impl GameObserver for NoPictures {}
