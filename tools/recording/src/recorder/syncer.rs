//! The thread that brings a file to the disk, so that a slow disk does not delay writing.

use std::io;
use std::sync::mpsc::{SyncSender, TrySendError, sync_channel};
use std::thread::{self, JoinHandle};

use super::sink::Syncing;

/// The thread.
#[derive(Debug)]
pub(super) struct Syncer {
    requests: Option<SyncSender<()>>,
    thread: Option<JoinHandle<io::Result<()>>>,
}

impl Syncer {
    pub(super) fn start(mut sync: Syncing) -> io::Result<Self> {
        let (requests, received) = sync_channel(1);
        let work = move || {
            while received.recv().is_ok() {
                sync()?;
            }
            Ok(())
        };
        let thread = thread::Builder::new().name("recorder sync".to_owned()).spawn(work)?;
        Ok(Self { requests: Some(requests), thread: Some(thread) })
    }

    /// Requests that everything written so far is brought to the disk; returns the failure of an earlier request.
    pub(super) fn request(&mut self) -> io::Result<()> {
        match self.requests.as_ref().map(|requests| requests.try_send(())) {
            Some(Err(TrySendError::Disconnected(()))) => self.finish(),
            // A request that waits covers this one.
            _ => Ok(()),
        }
    }

    /// Waits until everything written is on the disk.
    pub(super) fn finish(&mut self) -> io::Result<()> {
        // A request that waits covers this one; if the thread has ended, its result says why.
        let _ = self.requests.take().map(|requests| requests.try_send(()));
        let failed = || Err(io::Error::other("the thread that syncs failed"));
        self.thread.take().map_or(Ok(()), |thread| thread.join().unwrap_or_else(|_| failed()))
    }
}
