//! What all sessions share.

use std::sync::Arc;

use crate::options::Options;
use crate::pages::Pages;
use crate::program::Program;

/// What all sessions share. Clones are the same.
#[derive(Clone, Default)]
pub(crate) struct Common {
    pub(crate) options: Arc<Options>,
    pub(crate) pages: Arc<Pages>,
    pub(crate) program: Arc<Program>,
}
