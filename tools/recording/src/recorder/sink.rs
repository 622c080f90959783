//! Targets of a recording.

use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};

/// Target of a recording: a file, or something that fails in a test.
pub trait Sink: Write + Send {
    /// Cuts the target to a length and continues there.
    ///
    /// # Errors
    /// If it cannot be cut.
    fn truncate(&mut self, length: u64) -> io::Result<()>;

    /// Brings everything written to the disk.
    ///
    /// # Errors
    /// If the disk refuses.
    fn sync(&mut self) -> io::Result<()>;
}

impl Sink for File {
    fn truncate(&mut self, length: u64) -> io::Result<()> {
        self.set_len(length)?;
        self.seek(SeekFrom::Start(length)).map(drop)
    }

    fn sync(&mut self) -> io::Result<()> {
        match self.sync_data() {
            // A pipe or a device has nothing to sync.
            Err(error) if error.kind() == io::ErrorKind::InvalidInput => Ok(()),
            result => result,
        }
    }
}

impl<S: Sink + ?Sized> Sink for Box<S> {
    fn truncate(&mut self, length: u64) -> io::Result<()> {
        (**self).truncate(length)
    }

    fn sync(&mut self) -> io::Result<()> {
        (**self).sync()
    }
}
