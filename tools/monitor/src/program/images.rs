//! Image files of a program.

use std::path::{Path, PathBuf};

use bica_wire::model::Invalid;

/// Image files that a program can read. They are shown as a session.
pub trait ImageFiles: Send + Sync {
    /// Name of the session.
    fn name(&self) -> String;

    /// Lists the files, in order.
    ///
    /// # Errors
    /// If the folder cannot be read.
    fn list(&self) -> Result<Vec<PathBuf>, Invalid>;

    /// Reads a file. Returns width and height, px, and the pixels in YUYV 4:2:2.
    ///
    /// # Errors
    /// The reason why the file is skipped.
    fn read(&self, file: &Path) -> Result<(u16, u16, Vec<u8>), String>;
}
