//! The bounded queue between the loop and the thread that writes.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use crc32fast::Hasher;

use super::{Backpressure, RecorderOptions};
use crate::header::Ending;
use crate::message::{Costs, LogLine, RunEvent, TreeRecord};
use crate::request::RequestRecord;

/// Time after which the thread checks the queue without being woken.
const POLL: Duration = Duration::from_millis(50);
/// Number of entries after which the thread is woken: waking it in each cycle would cost the loop time.
const WAKE_AFTER: usize = 64;
/// Number of entries that events, log lines and costs may occupy beyond the limit for cycles.
const EXTRA_ENTRIES: usize = 1000;

/// The values of a cycle.
#[derive(Debug)]
pub(super) struct CycleValues {
    pub(super) instant: u64,
    pub(super) requests: Vec<RequestRecord>,
    /// The sensor values without their large data, then the command.
    pub(super) message: Vec<u8>,
    pub(super) sensor_bytes: usize,
    pub(super) blobs: BlobValues,
    /// In some cycles an [`OutputsRecord`](crate::OutputsRecord) in postcard's format.
    pub(super) outputs: Option<Vec<u8>>,
    /// Active components and states, if they changed.
    pub(super) tree: Option<TreeRecord>,
}

/// The large data of a cycle.
#[derive(Debug)]
pub(super) enum BlobValues {
    /// No large data.
    None,
    /// All of it.
    Kept(Vec<KeptBlob>),
    /// The digest alone; the data is not stored.
    Digest(Hasher),
}

/// Large data, and the position in the encoded sensor values at which its format begins.
#[derive(Debug)]
pub(super) struct KeptBlob {
    pub(super) at: usize,
    pub(super) data: Data,
}

#[derive(Debug)]
pub(super) enum Data {
    Copy(Vec<u8>),
    Shared(Arc<Vec<u8>>),
}

impl KeptBlob {
    pub(super) fn bytes(&self) -> &[u8] {
        match &self.data {
            Data::Copy(bytes) => bytes,
            Data::Shared(bytes) => bytes,
        }
    }
}

/// An entry of the queue.
#[derive(Debug)]
pub(super) enum Entry {
    Cycle(CycleValues),
    Event(RunEvent),
    Log(LogLine),
    Costs(Costs),
}

#[derive(Debug)]
struct State {
    entries: VecDeque<Entry>,
    /// Entries taken by the thread and not yet written.
    taken: usize,
    /// Number of cycles whose large data waits.
    images: usize,
    /// Buffers for copies of large data that are free.
    buffers: Vec<Vec<u8>>,
    dropped_images: u64,
    closing: Option<Ending>,
    /// Whether the queue was full.
    overflow: bool,
}

/// The queue.
#[derive(Debug)]
pub(super) struct Queue {
    state: Mutex<State>,
    wake: Condvar,
    room: Condvar,
    ended: AtomicBool,
    options: RecorderOptions,
}

/// Contents of the queue that the thread takes.
pub(super) struct Batch {
    pub(super) entries: VecDeque<Entry>,
    /// Result of the run, once it is over.
    pub(super) closing: Option<Ending>,
    pub(super) dropped_images: u64,
    pub(super) overflow: bool,
}

impl Queue {
    pub(super) fn new(options: RecorderOptions) -> Self {
        let state = State {
            entries: VecDeque::with_capacity(options.cycles.min(1000)),
            taken: 0,
            images: 0,
            buffers: Vec::with_capacity(options.images),
            dropped_images: 0,
            closing: None,
            overflow: false,
        };
        Self {
            state: Mutex::new(state),
            wake: Condvar::new(),
            room: Condvar::new(),
            ended: AtomicBool::new(false),
            options,
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        // No code panics while it holds the lock.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn has_ended(&self) -> bool {
        self.ended.load(Ordering::Relaxed)
    }

    /// Adds an entry. Without room, a cycle waits or ends the recording, and other entries are dropped.
    pub(super) fn push(&self, entry: Entry) {
        let mut state = self.lock();
        let is_cycle = matches!(entry, Entry::Cycle(_));
        let limit = self.options.cycles + if is_cycle { 0 } else { EXTRA_ENTRIES };
        while state.entries.len() + state.taken >= limit {
            if self.has_ended() || !is_cycle {
                return;
            }
            if self.options.backpressure == Backpressure::Drop {
                state.overflow = true;
                self.ended.store(true, Ordering::Relaxed);
                self.wake.notify_one();
                return;
            }
            self.wake.notify_one();
            state = self.room.wait_timeout(state, POLL).unwrap_or_else(PoisonError::into_inner).0;
        }
        if self.has_ended() {
            return;
        }
        state.entries.push_back(entry);
        if state.entries.len().is_multiple_of(WAKE_AFTER) {
            self.wake.notify_one();
        }
    }

    /// Makes room for the large data of a cycle; returns false if it has to be dropped, which is counted.
    pub(super) fn make_room(&self) -> bool {
        let mut state = self.lock();
        while state.images >= self.options.images {
            if self.has_ended() {
                return false;
            }
            if self.options.backpressure == Backpressure::Drop {
                state.dropped_images += 1;
                return false;
            }
            self.wake.notify_one();
            state = self.room.wait_timeout(state, POLL).unwrap_or_else(PoisonError::into_inner).0;
        }
        self.take_room(&mut state);
        true
    }

    /// Takes room for large data that need not be stored; returns whether there was room.
    pub(super) fn try_make_room(&self) -> bool {
        let mut state = self.lock();
        let is_free = state.images < self.options.images;
        if is_free {
            self.take_room(&mut state);
        }
        is_free
    }

    fn take_room(&self, state: &mut State) {
        state.images += 1;
        if state.images > self.options.images / 2 {
            self.wake.notify_one();
        }
    }

    /// Returns a buffer for a copy of large data.
    pub(super) fn take_buffer(&self) -> Vec<u8> {
        self.lock().buffers.pop().unwrap_or_default()
    }

    /// Releases the room of large data.
    pub(super) fn give_back(&self, blobs: BlobValues) {
        let BlobValues::Kept(kept) = blobs else { return };
        let mut state = self.lock();
        for blob in kept {
            if let Data::Copy(buffer) = blob.data {
                state.buffers.push(buffer);
            }
        }
        state.images -= 1;
        self.room.notify_one();
    }

    /// Sets the result of the run, which is over.
    pub(super) fn close(&self, ending: Ending) {
        self.lock().closing = Some(ending);
        self.wake.notify_one();
    }

    /// Waits a short time for entries and takes all of them; those of the last call count as written.
    pub(super) fn take(&self) -> Batch {
        let mut state = self.lock();
        state.taken = 0;
        self.room.notify_one();
        if state.entries.is_empty() && state.closing.is_none() && !state.overflow {
            state = self.wake.wait_timeout(state, POLL).unwrap_or_else(PoisonError::into_inner).0;
        }
        state.taken = state.entries.len();
        Batch {
            entries: std::mem::take(&mut state.entries),
            closing: state.closing.clone(),
            dropped_images: state.dropped_images,
            overflow: state.overflow,
        }
    }

    /// Ends the recording: further entries are dropped.
    pub(super) fn end(&self) {
        self.ended.store(true, Ordering::Relaxed);
        let mut state = self.lock();
        state.entries = VecDeque::new();
        state.taken = 0;
        self.room.notify_all();
    }
}
