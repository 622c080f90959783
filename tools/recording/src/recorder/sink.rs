//! Targets of a recording.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;

/// Target of a recording: a file, or in a test a target that fails.
pub trait Sink: Write + Send {
    /// Cuts the target to a length and continues there.
    ///
    /// # Errors
    /// If it cannot be cut.
    fn truncate(&mut self, length: u64) -> io::Result<()>;

    /// Returns a function that brings everything written to the disk. A thread of its own calls it.
    ///
    /// # Errors
    /// If the operating system refuses.
    fn syncing(&self) -> io::Result<Syncing>;
}

/// Function that brings everything written to the disk.
pub type Syncing = Box<dyn FnMut() -> io::Result<()> + Send>;

/// Creates a file for a recording, or empties an existing one if it may be replaced. The file is locked, so that it has one
/// writer.
///
/// # Errors
/// If the file cannot be created, exists and is not to be replaced, or another recorder writes it.
pub fn create(path: &Path, replace: bool) -> io::Result<File> {
    let file = OpenOptions::new().write(true).create(true).truncate(false).create_new(!replace).open(path)?;
    if matches!(file.try_lock(), Err(TryLockError::WouldBlock)) {
        return Err(io::Error::new(io::ErrorKind::ResourceBusy, "another program writes it"));
    }
    ignore_devices(file.set_len(0))?;
    Ok(file)
}

/// Ignores the refusal of a pipe or a device, which has no length and nothing to sync.
fn ignore_devices(result: io::Result<()>) -> io::Result<()> {
    result.or_else(|error| if error.kind() == io::ErrorKind::InvalidInput { Ok(()) } else { Err(error) })
}

impl Sink for File {
    fn truncate(&mut self, length: u64) -> io::Result<()> {
        self.set_len(length)?;
        self.seek(SeekFrom::Start(length)).map(drop)
    }

    fn syncing(&self) -> io::Result<Syncing> {
        let file = self.try_clone()?;
        Ok(Box::new(move || ignore_devices(file.sync_data())))
    }
}

impl<S: Sink + ?Sized> Sink for Box<S> {
    fn truncate(&mut self, length: u64) -> io::Result<()> {
        (**self).truncate(length)
    }

    fn syncing(&self) -> io::Result<Syncing> {
        (**self).syncing()
    }
}
