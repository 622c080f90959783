//! The files of a recording that is split.

use std::{fmt, io, mem};

use super::{Output, Sink};
use crate::header::{Ending, Header};
use crate::part::{RunPart, Split};

/// Function that creates the file of the part with a number.
pub(super) type NextFile<S> = Box<dyn FnMut(u32) -> io::Result<S> + Send>;

/// The files of a recording that is split.
pub(super) struct Parts<S> {
    split: Split,
    next: NextFile<S>,
    /// Time of the first cycle of the part that is being written, ns.
    begin: Option<u64>,
    /// The part before it: its last bytes may still be on their way to the disk.
    former: Option<Output<S>>,
    /// Length of all parts before, bytes.
    pub(super) bytes: u64,
    /// Number of images that were dropped in all parts before.
    pub(super) dropped_images: u64,
}

impl<S> fmt::Debug for Parts<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Parts").field("split", &self.split).finish_non_exhaustive()
    }
}

impl<S: Sink> Parts<S> {
    pub(super) fn new(split: Split, next: NextFile<S>) -> Self {
        Self { split, next, begin: None, former: None, bytes: 0, dropped_images: 0 }
    }

    /// Returns whether a cycle at a time, ns, belongs to the next part.
    fn is_due(&mut self, time: u64, output: &Output<S>) -> bool {
        let begin = *self.begin.get_or_insert(time);
        !output.is_empty()
            && match self.split {
                Split::Time(longest) => time.saturating_sub(begin) >= longest,
                Split::Size(largest) => output.length() + output.pending() as u64 >= largest,
            }
    }

    /// Closes the part that is being written and begins the next one, if a cycle at a time, ns, belongs there. `dropped_images` is
    /// their number since the start of the run.
    pub(super) fn advance(
        &mut self,
        time: u64,
        output: &mut Output<S>,
        header: &mut Header,
        dropped_images: u64,
    ) -> io::Result<()> {
        if !self.is_due(time, output) {
            return Ok(());
        }
        let Some(part) = &mut header.part else { return Ok(()) };
        // This part keeps all its cycles, also if the next one cannot begin.
        output.flush()?;
        part.number += 1;
        let failed = |error: io::Error| io::Error::new(error.kind(), format!("part {}: {error}", part.number));
        let file = (self.next)(part.number).map_err(failed)?;
        let next = output.next(file, header)?;
        self.sync()?;
        let mut former = mem::replace(output, next);
        if let Some(reason) = former.close(None, Ending::default(), dropped_images - self.dropped_images) {
            return Err(io::Error::other(reason));
        }
        self.begin = Some(time);
        self.dropped_images = dropped_images;
        self.bytes += former.length();
        self.former = Some(former);
        Ok(())
    }

    /// Waits until the former part is on the disk. Its sync had the time of a whole part.
    pub(super) fn sync(&mut self) -> io::Result<()> {
        self.former.take().map_or(Ok(()), |mut former| former.sync())
    }
}

/// Returns the header of the first part.
pub(super) fn first(header: &Header) -> Header {
    Header { part: Some(RunPart::first()), ..header.clone() }
}
