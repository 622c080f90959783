//! Replacement of pictures and films in a program that was built without them.

use std::path::Path;

use bica_app::Failure;

use crate::game::observer::GameObserver;
use crate::play::built_without;

/// Album or film of such a program; uninhabited.
#[derive(Debug)]
pub(crate) enum NoPictures {}

impl NoPictures {
    /// Returns an error: pictures and films are missing from this program.
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
