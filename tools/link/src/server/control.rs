//! State of the link in the loop, shared by its two halves.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use bica_wire::message::{Change, CycleInfo, LeaseAction, RefusalCode, Request};
use bica_wire::server::Lease;

use super::ServerOptions;
use super::connection::Connection;
use super::hub::{Command, Hub, Inbound};
use super::outbox::{AnswerKind, Message};
use super::watcher::Watcher;

/// A request that was applied; the answer follows at the end of its cycle.
#[derive(Debug)]
pub(super) struct Applied {
    pub(super) connection: u64,
    pub(super) number: u32,
    pub(super) arrived: u64,
    pub(super) change: Change,
}

/// State of the link in the loop. Only the loop's thread locks it, so it never waits.
#[derive(Debug)]
pub(super) struct Control {
    pub(super) hub: Arc<Hub>,
    realtime: bool,
    watch_only: bool,
    began: Instant,
    pub(super) watchers: Vec<Watcher>,
    /// Information that at least one monitor watches in every n-th cycle, sorted.
    pub(super) watched: Vec<((u16, u16), u16)>,
    pub(super) lease: Lease,
    pub(super) applied: Vec<Applied>,
    /// Components whose parameters every monitor gets at the end of the cycle.
    pub(super) changed: BTreeSet<u16>,
    /// Connections that get all parameters at the end of the cycle.
    pub(super) readers: BTreeSet<u64>,
    /// Numbers of the next cycle.
    pub(super) next: CycleInfo,
}

impl Control {
    pub(super) fn new(hub: Arc<Hub>, options: ServerOptions) -> Self {
        Self {
            hub,
            realtime: options.realtime,
            watch_only: options.watch_only,
            began: Instant::now(),
            watchers: Vec::new(),
            watched: Vec::new(),
            lease: Lease::new(options.silence, seconds()),
            applied: Vec::new(),
            changed: BTreeSet::new(),
            readers: BTreeSet::new(),
            next: CycleInfo::default(),
        }
    }

    /// Time by which the operator's silence is measured.
    pub(super) fn lease_time(&self, now: bica::Instant) -> Duration {
        if self.realtime { Duration::from_micros(now.as_micros()) } else { self.began.elapsed() }
    }

    pub(super) fn watcher(&mut self, connection: u64) -> Option<&mut Watcher> {
        self.watchers.iter_mut().find(|watcher| watcher.connection.id == connection)
    }

    /// Sends a message to one monitor, if it is still connected.
    pub(super) fn tell(&mut self, connection: u64, message: Message) {
        if let Some(watcher) = self.watcher(connection) {
            watcher.tell(message);
        }
    }

    /// Lists what is watched anew, after a monitor changed it or left.
    pub(super) fn list_watched(&mut self) {
        let all = self.watchers.iter().flat_map(|watcher| watcher.watched.iter());
        self.watched = all.map(|(&key, &every)| (key, every)).collect();
        self.watched.sort_unstable();
        self.watched.dedup();
    }

    /// Sends the lease to every monitor.
    fn announce_lease(&mut self, now: bica::Instant) {
        for watcher in &mut self.watchers {
            watcher.tell(Message::Lease(self.lease.state(watcher.connection.id, now)));
        }
    }

    /// Sends a line of the log to every monitor.
    pub(super) fn log(&mut self, now: bica::Instant, level: u8, text: &str) {
        let text: Arc<str> = text.into();
        for watcher in &mut self.watchers {
            watcher.tell(Message::Log { time_us: now.as_micros(), level, text: Arc::clone(&text) });
        }
    }

    /// Ends the lease of a silent operator.
    pub(super) fn check_silence(&mut self, now: bica::Instant) {
        let time = self.lease_time(now);
        if self.lease.check_silence(time) {
            self.announce_lease(now);
            self.log(now, 3, "operator: silent for too long, holds and rates end");
        }
    }

    /// Handles a message of a monitor. Returns a request that is to be applied.
    pub(super) fn handle(&mut self, now: bica::Instant, message: Inbound) -> Option<Applied> {
        let Inbound { from, arrived, command } = message;
        if from.is_closed() {
            return None;
        }
        let id = from.id;
        match command {
            Command::Open => self.watchers.push(Watcher::new(from)),
            Command::Attach => {
                let lease = self.lease.state(id, now);
                self.tell(id, Message::Lease(lease));
            }
            Command::Watch(watch) => {
                if let Some(watcher) = self.watcher(id) {
                    watcher.every = watch.every;
                }
            }
            Command::WatchInfo(watch) => {
                if self.watcher(id).is_some_and(|watcher| !watcher.watch(watch)) {
                    let text = "a monitor cannot watch so much information".into();
                    self.tell(id, Message::Log { time_us: now.as_micros(), level: 3, text });
                }
                self.list_watched();
            }
            Command::ReadParams => {
                self.readers.insert(id);
            }
            Command::Lease(action) => self.act(now, id, action),
            Command::Request(request) => return self.admit(now, &from, arrived, *request),
        }
        None
    }

    fn act(&mut self, now: bica::Instant, connection: u64, action: LeaseAction) {
        let time = self.lease_time(now);
        if !self.watch_only && self.lease.act(connection, action, time) {
            self.announce_lease(now);
        } else if !matches!(action, LeaseAction::Keep { .. } if self.lease.state(connection, now).yours) {
            let lease = self.lease.state(connection, now);
            self.tell(connection, Message::Lease(lease));
        }
    }

    /// Checks whether a request may be applied; else answers it.
    fn admit(&mut self, now: bica::Instant, from: &Connection, arrived: u64, request: Request) -> Option<Applied> {
        let time = self.lease_time(now);
        let admitted = if self.watch_only {
            Err(RefusalCode::Unsupported)
        } else {
            self.lease.admit(from.id, &request, time, now)
        };
        let Request { number, change, .. } = request;
        let Err(code) = admitted else { return Some(Applied { connection: from.id, number, arrived, change }) };
        self.refuse(from.id, number, arrived, code, 0, code.text().to_owned());
        None
    }

    pub(super) fn refuse(
        &mut self,
        connection: u64,
        number: u32,
        arrived: u64,
        code: RefusalCode,
        entry: u16,
        text: String,
    ) {
        let result = AnswerKind::Refused { code, entry, text };
        let cycle = self.next.cycle;
        self.tell(connection, Message::Answer { number, cycle, arrived, result });
    }
}

/// Seconds since 1970: numbers of leases of an earlier run of the program must not be valid in this one.
fn seconds() -> u32 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(1, |since| since.as_secs() as u32)
}
