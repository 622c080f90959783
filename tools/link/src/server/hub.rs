//! Data that all threads of a server share.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::thread;
use std::time::{Duration, Instant};

use bica::Graph;
use bica_wire::SCHEMA;
use bica_wire::message::{Attached, LeaseAction, LogSource, Offers, Request, Stop, Watch, WorldRequest};
use bica_wire::model::Description;

use super::connection::Connection;
use super::counters::Counters;
use super::images::has_blobs;
use super::key::Key;
use super::options::{MAX_MONITORS, ServerOptions};
use super::outbox::{Message, MessageSchemas};

/// Largest number of messages of a connection that wait for the loop. A connection that sends more is not read meanwhile.
pub(super) const MAX_PENDING: usize = 32;
/// Largest number of connections that have sent nothing yet.
const MAX_SILENT: usize = 32;
/// Number of messages of a connection to the loop that are not counted: its `Open`.
const UNCOUNTED: usize = 1;

/// Message of a connection to the loop.
pub(super) struct Inbound {
    pub(super) from: Arc<Connection>,
    /// Number of the cycle that was next when the message arrived.
    pub(super) arrived: u64,
    pub(super) command: Command,
}

pub(super) enum Command {
    Open,
    Attach,
    Watch(Watch),
    WatchKey((Key, u16)),
    WatchImages(u16),
    WatchTaken(bool),
    Stop(Stop, bool),
    ReadParams,
    Lease(LeaseAction),
    Request(Box<Request>),
    World(WorldRequest),
}

impl Command {
    /// Returns whether it stops the robot with this tree.
    pub(super) fn stops(&self, graph: &Graph) -> bool {
        matches!(self, Self::Request(request) if request.change.is_stop(graph))
    }
}

#[derive(Debug)]
pub(super) struct Hub {
    pub(super) graph: &'static Graph,
    /// Description of the same tree and its world, for texts.
    pub(super) description: Description,
    tree_hash: u64,
    pub(super) messages: MessageSchemas,
    pub(super) options: ServerOptions,
    /// Whether the robot is a recorded one, which does not run.
    pub(super) is_recorded: bool,
    /// Queues for messages that only watch, for stops, and for all others.
    watches: SyncSender<Inbound>,
    stops: SyncSender<Inbound>,
    inbox: SyncSender<Inbound>,
    connections: Mutex<Vec<Weak<Connection>>>,
    /// Connections that have sent nothing yet, the oldest first.
    silent: Mutex<VecDeque<Weak<Connection>>>,
    pub(super) counters: Arc<Counters>,
    last_id: AtomicU64,
    /// Number of the next cycle.
    pub(super) next_cycle: AtomicU64,
    /// Instant of the last cycle, µs.
    pub(super) time_us: AtomicU64,
    pub(super) stopped: AtomicBool,
    /// Result of the run.
    result: Mutex<Option<Arc<str>>>,
}

impl Hub {
    pub(super) fn new(
        graph: &'static Graph,
        tree_hash: u64,
        messages: MessageSchemas,
        options: &ServerOptions,
        is_recorded: bool,
    ) -> (Self, [Receiver<Inbound>; 3]) {
        let (inbox, receiver) = sync_channel((MAX_PENDING + UNCOUNTED) * MAX_MONITORS);
        let (watches, watch_receiver) = sync_channel(MAX_PENDING * MAX_MONITORS);
        let (stops, stop_receiver) = sync_channel(MAX_PENDING * MAX_MONITORS);
        let hub = Self {
            graph,
            description: Description::of(graph).with_actions(options.actions),
            tree_hash,
            messages,
            options: *options,
            is_recorded,
            watches,
            stops,
            inbox,
            connections: Mutex::default(),
            silent: Mutex::default(),
            counters: Arc::default(),
            last_id: AtomicU64::new(0),
            next_cycle: AtomicU64::new(0),
            time_us: AtomicU64::new(0),
            stopped: AtomicBool::new(false),
            result: Mutex::default(),
        };
        (hub, [receiver, watch_receiver, stop_receiver])
    }

    pub(super) fn attached(&self) -> Attached<'static> {
        Attached {
            schema: SCHEMA,
            tree_hash: self.tree_hash,
            name: self.graph.name,
            realtime: self.options.realtime,
            silence_ms: self.options.silence.as_millis() as u32,
            offers: self.offers(),
        }
    }

    /// Returns the services that this server offers.
    pub(super) fn offers(&self) -> Offers {
        let operate = if self.options.watch_only { Offers::default() } else { Offers::OPERATE };
        let images = if has_blobs(self.messages[0]) { Offers::IMAGES } else { Offers::default() };
        let costs = if self.is_recorded { Offers::default() } else { Offers::COSTS };
        self.options.offers.with(operate).with(images).with(Offers::CONDITIONS).with(costs)
    }

    /// Returns the result of the run.
    pub(super) fn result(&self) -> Option<Arc<str>> {
        self.result.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Sets the result of the run, and sends it to every monitor.
    pub(super) fn set_result(&self, text: &str) {
        let text: Arc<str> = text.into();
        *self.result.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::clone(&text));
        self.push_to_each(&Message::Result(text));
    }

    /// Returns a number that no other connection of this server has.
    pub(super) fn next_id(&self) -> u64 {
        self.last_id.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Adds a connection that has sent nothing yet to the list. If there are too many, the oldest is closed.
    pub(super) fn wait_for_message(&self, connection: &Arc<Connection>) {
        let mut silent = self.silent.lock().unwrap_or_else(PoisonError::into_inner);
        silent.retain(|connection| connection.strong_count() > 0);
        silent.push_back(Arc::downgrade(connection));
        if silent.len() > MAX_SILENT
            && let Some(oldest) = silent.pop_front().and_then(|oldest| oldest.upgrade())
        {
            oldest.close();
        }
    }

    /// Adds a connection that has sent its first message to the list for [`log`](Self::log) and [`end`](Self::end), and to the
    /// loop.
    pub(super) fn begin(&self, connection: &Arc<Connection>) {
        let is_other = |other: &Weak<Connection>| !std::ptr::eq(other.as_ptr(), Arc::as_ptr(connection));
        self.silent.lock().unwrap_or_else(PoisonError::into_inner).retain(is_other);
        let mut connections = self.connections.lock().unwrap_or_else(PoisonError::into_inner);
        connections.retain(|connection| connection.strong_count() > 0);
        connections.push(Arc::downgrade(connection));
        drop(connections);
        self.deliver(connection, Command::Open);
    }

    /// Hands a message to the loop. Returns whether a loop will receive it.
    pub(super) fn deliver(&self, from: &Arc<Connection>, command: Command) -> bool {
        let arrived = self.next_cycle.load(Ordering::Relaxed);
        // A breakpoint uses the queue of requests, so that it is set before a request that was sent after it.
        let only_watches =
            matches!(command, Command::Watch(_) | Command::WatchKey(_) | Command::WatchImages(_) | Command::ReadParams);
        let inbox = match command {
            _ if only_watches => &self.watches,
            _ if command.stops(self.graph) => &self.stops,
            _ => &self.inbox,
        };
        match inbox.try_send(Inbound { from: Arc::clone(from), arrived, command }) {
            Ok(()) => true,
            // The queue has room for all messages of open connections that may wait. It is full only if it holds messages of
            // closed ones, because the loop stands still.
            Err(TrySendError::Full(_)) => {
                from.overflow();
                true
            }
            Err(TrySendError::Disconnected(_)) => false,
        }
    }

    pub(super) fn log(&self, level: u8, source: LogSource, text: &str) {
        let time_us = self.time_us.load(Ordering::Relaxed);
        self.push_to_each(&Message::Log { time_us, level, source, text: text.into() });
    }

    /// Sends an event of the world to every monitor, with the time of the last cycle.
    pub(super) fn happened(&self, kind: &str, detail: &str) {
        let time_us = self.time_us.load(Ordering::Relaxed);
        self.push_to_each(&Message::Happened(time_us, kind.into(), detail.into()));
    }

    /// Adds a message to the queue of each connection. Not for the loop, which never waits.
    fn push_to_each(&self, message: &Message) {
        self.each(|connection| connection.push(message.clone()));
    }

    /// Sends every monitor the reason for the end of the server, waits at most `longest` for the end of all connections, and
    /// closes the rest.
    pub(super) fn end(&self, reason: &'static str, longest: Duration) {
        self.push_to_each(&Message::Closing(reason));
        let began = Instant::now();
        while self.counters.open.load(Ordering::Relaxed) > 0 && began.elapsed() < longest {
            thread::sleep(Duration::from_millis(2));
        }
        self.each(Connection::close);
    }

    fn each(&self, action: impl Fn(&Connection)) {
        let connections = self.connections.lock().unwrap_or_else(PoisonError::into_inner).clone();
        connections.iter().filter_map(Weak::upgrade).for_each(|connection| action(&connection));
    }
}
