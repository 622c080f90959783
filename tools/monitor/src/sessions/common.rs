//! Data that all sessions share.

use std::sync::Arc;

use crate::options::Options;
use crate::pages::Pages;
use crate::program::Program;

/// Data that all sessions share. Clones refer to the same data.
#[derive(Clone, Default)]
pub(crate) struct Common {
    pub(crate) options: Arc<Options>,
    pub(crate) pages: Arc<Pages>,
    pub(crate) program: Arc<Program>,
}
