//! State of the link in the loop, shared by its two halves.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::sync::Arc;
use std::time::Duration;

use bica_wire::message::{
    Change, CycleInfo, LeaseAction, LogSource, Offers, RefusalCode, Request, Requested, WorldChange, WorldRequest,
};
use bica_wire::server::Lease;

use super::connection::Connection;
use super::cycle_data::CyclePool;
use super::hub::{Command, Hub, Inbound};
use super::key::Key;
use super::options::ServerOptions;
use super::outbox::{AnswerKind, KnownSchema, Message};
use super::pace::{LoopClock, Pace};
use super::scene::WorldScenes;
use super::stops::Stops;
use super::watcher::Watcher;
use super::watchers::Watchers;

/// Reason for the refusal of all requests to a recorded robot.
const RECORDED: &str =
    "this is a recording that is played, in which nothing can be changed: attach to the robot itself";

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
    /// Whether silence is measured in the robot's time.
    by_robot: bool,
    pub(super) watch_only: bool,
    clock: LoopClock,
    pub(super) pace: Pace,
    pub(super) watchers: Watchers,
    /// Keys that are due in a cycle; the memory is reused.
    pub(super) due: Vec<Key>,
    pub(super) stops: Stops,
    pub(super) shown: WorldScenes,
    /// Whether requests were applied without a cycle since the last cycle: the world may be paused for long.
    pub(super) stands: bool,
    /// Memory of the data of cycles.
    pub(super) pool: CyclePool,
    pub(super) lease: Lease,
    pub(super) applied: Vec<Applied>,
    /// Components whose parameters every monitor gets at the end of the cycle.
    pub(super) changed: Vec<u16>,
    /// Schemas of all outputs; none before the first request for them.
    pub(super) schemas: Option<Arc<[KnownSchema]>>,
    /// Connections that get these schemas and all parameters at the end of the cycle.
    pub(super) readers: Vec<u64>,
    /// Numbers of the next cycle.
    pub(super) next: CycleInfo,
    /// Numbers of the last cycle.
    pub(super) last: Option<CycleInfo>,
}

impl Control {
    pub(super) fn new(hub: Arc<Hub>, options: ServerOptions, shown: WorldScenes) -> Self {
        Self {
            hub,
            by_robot: options.realtime && !options.offers.contains(Offers::PAUSE),
            watch_only: options.watch_only,
            clock: LoopClock::new(),
            pace: Pace::default(),
            watchers: Watchers::default(),
            due: Vec::new(),
            stops: Stops::default(),
            shown,
            stands: false,
            pool: CyclePool::default(),
            lease: Lease::new(options.silence),
            applied: Vec::new(),
            changed: Vec::new(),
            schemas: None,
            readers: Vec::new(),
            next: CycleInfo::default(),
            last: None,
        }
    }

    /// Returns the time by which the operator's silence is measured.
    pub(super) fn lease_time(&mut self, now: bica::Instant) -> Duration {
        if self.by_robot { Duration::from_micros(now.as_micros()) } else { self.clock.now() }
    }

    /// Sends a message to one monitor, if it is still connected.
    pub(super) fn tell(&mut self, connection: u64, message: Message) {
        if let Some(watcher) = self.watchers.find_mut(connection) {
            watcher.unsent.messages.push_back(message);
        }
    }

    /// Sends a message to every monitor.
    pub(super) fn tell_all(&mut self, message: &Message) {
        self.watchers.iter_mut().for_each(|watcher| watcher.unsent.messages.push_back(message.clone()));
    }

    /// Sends the lease to every monitor.
    pub(super) fn announce_lease(&mut self, now: bica::Instant) {
        for watcher in self.watchers.iter_mut() {
            let lease = Message::Lease(self.lease.state(watcher.connection.id, now));
            watcher.unsent.messages.push_back(lease);
        }
    }

    /// Sends an applied change to every monitor.
    pub(super) fn announce_change(&mut self, now: bica::Instant, change: &Change) {
        let requested = Requested { time_us: now.as_micros(), change: change.clone() };
        self.tell_all(&Message::Requested(Arc::new(requested)));
    }

    /// Sends a line about the operator to every monitor.
    pub(super) fn log(&mut self, now: bica::Instant, level: u8, text: &str) {
        let source = LogSource::Operator;
        self.tell_all(&Message::Log { time_us: now.as_micros(), level, source, text: text.into() });
    }

    /// Sends a warning to one monitor.
    fn warn(&mut self, connection: u64, now: bica::Instant, text: &str) {
        let (time_us, source) = (now.as_micros(), LogSource::Robot);
        self.tell(connection, Message::Log { time_us, level: 3, source, text: text.into() });
    }

    /// Ends the lease of a silent operator.
    pub(super) fn check_silence(&mut self, now: bica::Instant) {
        let time = self.lease_time(now);
        if self.lease.check_silence(time) {
            self.announce_lease(now);
            self.log(now, 3, "silent for too long, holds and rates end");
        }
    }

    /// Handles a message of a monitor. Returns a request that is to be applied.
    pub(super) fn handle(&mut self, now: bica::Instant, message: Inbound) -> Option<Applied> {
        let Inbound { from, arrived, command } = message;
        // A stop is applied even if its sender has left.
        if from.is_closed() && !command.stops(self.hub.graph) {
            return None;
        }
        let id = from.id;
        // A message in one queue may overtake the `Open` of its connection in another queue.
        if self.watchers.find(id).is_none() {
            self.watchers.add(Watcher::new(Arc::clone(&from)));
        }
        match command {
            Command::Open => {}
            Command::Attach => {
                let lease = self.lease.state(id, now);
                self.tell(id, Message::Lease(lease));
                if self.can_pause() {
                    self.tell(id, Message::World(self.pace.state(self.next.cycle)));
                }
                let announced: Vec<_> = self.shown.announced().cloned().map(Message::Scene).collect();
                let result = self.hub.result().map(Message::Result);
                announced.into_iter().chain(result).for_each(|message| self.tell(id, message));
            }
            Command::Watch(watch) => self.watchers.watch(id, watch.every),
            Command::WatchImages(every) => self.watchers.watch_images(id, every),
            Command::WatchTaken(is_watched) => self.stops.watch_taken(id, is_watched),
            Command::Stop(stop, is_set) => {
                let room = self.stops.set(id, stop, is_set);
                self.has_room(now, id, room);
            }
            Command::WatchKey(watch) => {
                let room = self.watchers.watch_key(id, watch);
                self.has_room(now, id, room);
            }
            Command::ReadParams => {
                self.readers.retain(|one| *one != id);
                self.readers.push(id);
            }
            Command::Lease(action) => self.act(now, id, action),
            Command::World(request) => self.change_world(now, id, arrived, request),
            Command::Request(request) => return self.admit(now, &from, arrived, *request),
        }
        None
    }

    fn has_room(&mut self, now: bica::Instant, connection: u64, room: bool) {
        if !room {
            self.warn(connection, now, "a monitor cannot watch so much");
        }
    }

    /// Removes disconnected monitors; another connection may continue the lease of one of them.
    pub(super) fn forget_closed(&mut self) {
        for closed in self.watchers.remove_closed() {
            self.lease.disconnect(closed);
            self.stops.forget(closed);
        }
    }

    fn act(&mut self, now: bica::Instant, connection: u64, action: LeaseAction) {
        let time = self.lease_time(now);
        self.forget_closed();
        let last = self.watchers.iter().map(|one| one.connection.id).find(|&one| self.lease.state(one, now).yours);
        if !self.watch_only && self.lease.act(connection, action, time, unpredictable()) {
            self.announce_lease(now);
            if let Some(last) = last.filter(|&last| last != connection) {
                self.warn(last, now, "control has ended: another monitor has taken it");
            }
        } else if !matches!(action, LeaseAction::Keep { .. } if self.lease.state(connection, now).yours) {
            let lease = self.lease.state(connection, now);
            self.tell(connection, Message::Lease(lease));
        }
    }

    /// Checks whether a request may be applied; if not, sends the refusal.
    fn admit(&mut self, now: bica::Instant, from: &Connection, arrived: u64, request: Request) -> Option<Applied> {
        let time = self.lease_time(now);
        let admitted = if self.watch_only {
            Err(RefusalCode::Unsupported)
        } else {
            self.lease.admit(from.id, &request, self.hub.graph, time, now)
        };
        let Request { number, change, .. } = request;
        let Err(code) = admitted else { return Some(Applied { connection: from.id, number, arrived, change }) };
        let text = if self.hub.is_recorded { RECORDED } else { code.text() };
        self.refuse(from.id, number, arrived, code, 0, text.to_owned());
        None
    }

    pub(super) fn can_pause(&self) -> bool {
        self.hub.offers().contains(Offers::PAUSE)
    }

    /// Pauses, continues or steps the world.
    fn change_world(&mut self, now: bica::Instant, connection: u64, arrived: u64, request: WorldRequest) {
        let time = self.lease_time(now);
        let WorldRequest { number, lease, expires_us, change } = request;
        if !self.can_pause() {
            let text = if self.hub.is_recorded { RECORDED } else { "time can be stopped only in a simulated world" };
            self.refuse(connection, number, arrived, RefusalCode::World, 0, text.to_owned());
            return;
        }
        let admitted = if self.watch_only {
            Err(RefusalCode::Unsupported)
        } else {
            self.lease.admit_lease(connection, (lease, expires_us), time, now)
        };
        if let Err(code) = admitted {
            self.refuse(connection, number, arrived, code, 0, code.text().to_owned());
            return;
        }
        let text = match change {
            WorldChange::Pause => "pause".to_owned(),
            WorldChange::Resume => "resume".to_owned(),
            WorldChange::Step { cycles } => format!("step {cycles}"),
        };
        self.pace.change(change);
        let (cycle, result) = (self.next.cycle, AnswerKind::Done(Vec::new()));
        self.tell(connection, Message::Answer { number, cycle, arrived, result });
        self.log(now, 2, &text);
        self.announce_world();
    }

    /// Sends the state of the world to every monitor.
    pub(super) fn announce_world(&mut self) {
        self.tell_all(&Message::World(self.pace.state(self.next.cycle)));
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

/// Returns a number that cannot be guessed, for a lease.
fn unpredictable() -> u64 {
    // The standard library takes its keys from the random numbers of the operating system.
    RandomState::new().build_hasher().finish()
}
