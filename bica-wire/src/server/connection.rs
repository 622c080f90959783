//! One monitor: its watched values and its pending messages.

use core::ops::Range;

use bica_core::graph::Graph;
use bica_core::{ComponentId, Instant};
use heapless::{Deque, Vec};

use super::refusal::PendingAnswer;
use crate::message::{CycleInfo, WatchOutput};
use crate::{GraphItems, describe};

/// Maximum number of outputs that a connection watches.
const MAX_WATCHED: usize = 128;
/// Number of bits in a word of the sets below.
const BITS: usize = 32;
/// Marks a line of the log about a refusal, which is sent as a warning.
pub(super) const REFUSED: u8 = u8::MAX;
/// Maximum number of lines of the log that wait; the oldest is dropped.
const MAX_LOG: usize = 4;

/// Set of entries of the list of watched outputs.
type WatchedSet = [u32; MAX_WATCHED / BITS];

/// One monitor.
pub(super) struct Connection {
    /// Time of the monitor's last message; `None` without a monitor.
    pub(super) heard: Option<Instant>,
    /// The answer to the last request, if it was not sent yet.
    pub(super) answer: Option<PendingAnswer>,
    /// Whether `Attached` is to be sent.
    pub(super) attached: bool,
    /// Whether to send the lease.
    pub(super) lease: bool,
    pub(super) log: Deque<LogEntry, MAX_LOG>,
    /// Indices of the components whose parameters are to be sent, and the next parameter of the first of them.
    pub(super) params: Range<u16>,
    pub(super) first_param: u16,
    /// Rest of the description.
    pub(super) description: Option<GraphItems<'static>>,
    /// A snapshot in every n-th cycle; 0: none.
    pub(super) every: u16,
    /// Next part of the snapshot that is due; `None`: none is due.
    pub(super) snapshot: Option<u8>,
    pub(super) watched: Vec<Watched, MAX_WATCHED>,
    /// Watched outputs that are due.
    pub(super) due: WatchedSet,
    /// Watched outputs whose schema was sent.
    pub(super) schemas: WatchedSet,
    /// Number of bytes of the next schema that have been sent.
    pub(super) schema_offset: usize,
    /// Entry at which the search for due outputs begins.
    pub(super) next_output: usize,
}

/// Output that a connection watches.
#[derive(Clone, Copy)]
pub(super) struct Watched {
    pub(super) component: u8,
    pub(super) output: u8,
    /// Interval: sent in every n-th cycle; 0: not sent any more.
    every: u16,
}

/// A line of the log.
pub(super) struct LogEntry {
    pub(super) time_us: u64,
    pub(super) level: u8,
    pub(super) text: &'static str,
    pub(super) component: Option<ComponentId>,
}

impl Connection {
    /// Creates a connection without a monitor.
    pub(super) const fn new() -> Self {
        Self {
            heard: None,
            answer: None,
            attached: false,
            lease: false,
            log: Deque::new(),
            params: 0..0,
            first_param: 0,
            description: None,
            every: 0,
            snapshot: None,
            watched: Vec::new(),
            due: [0; MAX_WATCHED / BITS],
            schemas: [0; MAX_WATCHED / BITS],
            schema_offset: 0,
            next_output: 0,
        }
    }

    /// Begins a session, which starts with the description.
    pub(super) fn begin(&mut self, graph: &'static Graph, clock: Instant) {
        self.heard = Some(clock);
        self.description = Some(describe(graph));
        (self.every, self.snapshot) = (0, None);
        self.watched.clear();
        (self.due, self.schemas) = ([0; MAX_WATCHED / BITS], [0; MAX_WATCHED / BITS]);
        (self.schema_offset, self.next_output) = (0, 0);
    }

    /// Changes how often an output is sent.
    pub(super) fn watch(&mut self, WatchOutput { component, output, every }: WatchOutput) {
        let (Ok(component), Ok(output)) = (u8::try_from(component), u8::try_from(output)) else { return };
        let same = |watched: &&mut Watched| (watched.component, watched.output) == (component, output);
        if let Some(watched) = self.watched.iter_mut().find(same) {
            watched.every = every;
        } else if every > 0 && self.watched.push(Watched { component, output, every }).is_err() {
            let text = "too many outputs";
            self.log(LogEntry { time_us: 0, level: 3, text, component: None });
        }
    }

    /// Adds a line of the log.
    pub(super) fn log(&mut self, entry: LogEntry) {
        if self.heard.is_none() {
            return;
        }
        if self.log.is_full() {
            self.log.pop_front();
        }
        let _ = self.log.push_back(entry);
    }

    /// Adds components whose parameters are to be sent. Components between these and the waiting ones are sent, too.
    pub(super) fn add_params(&mut self, Range { start, end }: Range<u16>) {
        if self.heard.is_some() {
            let waiting = if self.params.is_empty() { start..end } else { self.params.clone() };
            // The values that were sent may have changed: begin again.
            (self.params, self.first_param) = (start.min(waiting.start)..end.max(waiting.end), 0);
        }
    }

    /// Marks the data that are due after a cycle.
    pub(super) fn mark_due(&mut self, cycle: &CycleInfo) {
        let is_due = |every: u16| every > 0 && cycle.cycle.is_multiple_of(u64::from(every));
        // A snapshot of an earlier cycle that was not sent completely is dropped.
        self.snapshot = match self.snapshot {
            _ if is_due(self.every) => Some(0),
            Some(0) => Some(0),
            _ => None,
        };
        for (entry, watched) in self.watched.iter().enumerate() {
            if is_due(watched.every) {
                self.due[entry / BITS] |= 1 << (entry % BITS);
            }
        }
    }

    /// Returns the next entry whose output is due.
    pub(super) fn next_due(&self) -> Option<usize> {
        let count = self.watched.len();
        let is_due = |entry: &usize| contains(&self.due, *entry) && self.watched[*entry].every > 0;
        (self.next_output..count).chain(0..self.next_output.min(count)).find(is_due)
    }
}

/// Returns whether an entry is in a set.
pub(super) const fn contains(set: &WatchedSet, entry: usize) -> bool {
    set[entry / BITS] >> (entry % BITS) & 1 == 1
}

/// Adds an entry to a set, or removes it.
pub(super) const fn set(set: &mut WatchedSet, entry: usize, is_member: bool) {
    let bit = 1 << (entry % BITS);
    if is_member {
        set[entry / BITS] |= bit;
    } else {
        set[entry / BITS] &= !bit;
    }
}
