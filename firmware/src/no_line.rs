//! A missing line.

use core::convert::Infallible;
use core::future::pending;

use embedded_io_async::{ErrorType, Read, Write};

/// A line that a board does not have: it receives nothing and accepts nothing.
pub struct NoLine;

impl ErrorType for NoLine {
    type Error = Infallible;
}

impl Read for NoLine {
    async fn read(&mut self, _buffer: &mut [u8]) -> Result<usize, Infallible> {
        pending().await
    }
}

impl Write for NoLine {
    async fn write(&mut self, _bytes: &[u8]) -> Result<usize, Infallible> {
        pending().await
    }

    async fn flush(&mut self) -> Result<(), Infallible> {
        pending().await
    }
}
