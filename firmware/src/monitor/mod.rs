//! Server for the monitors of the robot.
//!
//! It follows the rules of `docs/link.md`. Its memory and its work in a cycle are bounded: it has two connections, the
//! body's line and the monitors' own line, and no queue of packets. A connection stores which data are due. A packet is
//! encoded when the line has room, with the values of that time, so new values replace unsent ones. Only an answer is
//! stored; until it is sent, no further message of this connection is handled.

mod connection;
mod info;
mod line;
mod packets;

use bica::runner::{Observer, Runner};
use bica::{ComponentId, Instant, Refusal};
use bica_wire::message::{Change, CycleInfo, LeaseAction, RefusalCode, Request};
use bica_wire::server::{Lease, read};
use bica_wire::{Encoder, FromMonitor};
use core::time::Duration;

use crate::tree::{Forward, GRAPH};
use connection::{Connection, Outcome, PendingAnswer};

pub(crate) use line::MonitorLine;

/// Silence of the operator after which the lease ends.
const SILENCE: Duration = Duration::from_secs(3);
/// Silence of a monitor after which nothing is sent to it any more.
const IDLE: embassy_time::Duration = embassy_time::Duration::from_secs(30);

/// A line over which a monitor is connected.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Line {
    /// The line of the body: its host forwards the packets of a monitor.
    Body = 0,
    /// The line for monitors.
    Monitor = 1,
}

impl Line {
    const fn id(self) -> u64 {
        self as u64
    }
}

/// Server for the monitors of the robot.
pub(crate) struct Monitor {
    lease: Lease,
    connections: [Connection; 2],
    /// Numbers of the next cycle.
    next: CycleInfo,
    /// Whether the robot's time advances with its clock.
    realtime: bool,
}

impl Monitor {
    /// Creates a server without monitors.
    pub(crate) const fn new() -> Self {
        Self {
            lease: Lease::new(SILENCE),
            connections: [const { Connection::new() }; 2],
            next: CycleInfo { cycle: 0, time_us: 0, sensed: 0, images: 0, overruns: 0 },
            realtime: false,
        }
    }

    /// States whether the robot's time advances with its clock.
    pub(crate) const fn set_realtime(&mut self, realtime: bool) {
        self.realtime = realtime;
    }

    /// Counts a set of sensor values.
    pub(crate) fn sensed(&mut self, has_image: bool) {
        self.next.sensed += 1;
        self.next.images += u64::from(has_image);
    }

    /// Whether messages of a connection can be handled, because its last answer was sent.
    pub(crate) const fn is_ready(&self, line: Line) -> bool {
        self.connections[line as usize].answer.is_none()
    }

    /// Starts a description, and with it a session, which ends all watching of this connection.
    pub(crate) fn describe(&mut self, line: Line) {
        self.connections[line as usize].begin();
    }

    /// Handles a message. `now` is the robot's time; `None` before the first cycle can run, when the lease is not
    /// available. `random`, a count of a fast clock, becomes the number of a new lease.
    pub(crate) fn receive<O: Observer<Forward>>(
        &mut self,
        line: Line,
        bytes: &[u8],
        runner: &mut Runner<&'static mut Forward, (), (), O>,
        now: Option<Instant>,
        random: u32,
    ) {
        let Ok(message) = postcard::from_bytes::<FromMonitor>(bytes) else { return };
        let connection = &mut self.connections[line as usize];
        connection.heard = Some(Instant::now());
        match message {
            FromMonitor::Attach => (connection.attached, connection.lease) = (true, true),
            FromMonitor::Watch(watch) => connection.every = watch.every,
            FromMonitor::WatchInfo(watch) => connection.watch(watch),
            FromMonitor::ReadParams => connection.params = u64::MAX,
            FromMonitor::Lease(action) => self.act(line, action, now, random),
            FromMonitor::Request(request) => self.request(line, request, runner, now),
        }
    }

    fn act(&mut self, line: Line, action: LeaseAction, now: Option<Instant>, random: u32) {
        if let Some(now) = now {
            if self.lease.act(line.id(), action, since_start(now), random.into()) {
                self.connections.iter_mut().for_each(|connection| connection.lease = true);
                return;
            }
            if matches!(action, LeaseAction::Keep { .. }) && self.lease.state(line.id(), now).yours {
                return;
            }
        }
        self.connections[line as usize].lease = true;
    }

    #[expect(clippy::needless_pass_by_value, reason = "a reference takes 32 bytes more of flash")]
    fn request<O: Observer<Forward>>(
        &mut self,
        line: Line,
        request: Request,
        runner: &mut Runner<&'static mut Forward, (), (), O>,
        now: Option<Instant>,
    ) {
        let time = now.unwrap_or(Instant::MIN);
        let admitted = match now {
            Some(now) => self.lease.admit(line.id(), &request, &GRAPH, since_start(now), now),
            None if request.change.is_stop(&GRAPH) => Ok(()),
            None => Err(RefusalCode::NoLease),
        };
        let outcome = match admitted {
            Err(code) => Outcome::refused(code, 0, code.text(), "", ""),
            Ok(()) => match self.apply(&request.change, runner, time) {
                Ok(()) => Outcome::Done(read::effective(runner.robot(), &request.change)),
                Err(refusal) => Outcome::of_refusal(&refusal),
            },
        };
        let (component, what, refused) = describe_change(&request.change);
        match outcome {
            Outcome::Done(_) => self.log(time, 2, what, component),
            Outcome::Refused { .. } => self.log(time, 3, refused, component),
        }
        let arrived = self.next.cycle;
        self.connections[line as usize].answer =
            Some(PendingAnswer { number: request.number, cycle: arrived, outcome });
    }

    fn apply<O: Observer<Forward>>(
        &mut self,
        change: &Change,
        runner: &mut Runner<&'static mut Forward, (), (), O>,
        now: Instant,
    ) -> Result<(), Refusal> {
        runner.request(now, change.borrow())?;
        if self.lease.record(change, &GRAPH) {
            self.connections.iter_mut().for_each(|connection| connection.lease = true);
        }
        if let Change::Params(batch) = change {
            let changed = batch.iter().fold(0, |set, setting| set | 1_u64 << (setting.component.index() & 63));
            self.connections.iter_mut().for_each(|connection| connection.add_params(changed));
        }
        Ok(())
    }

    /// Ends the lease of a silent operator, and the holds and rates of the lease. Called before each cycle.
    pub(crate) fn before_cycle<O: Observer<Forward>>(
        &mut self,
        runner: &mut Runner<&'static mut Forward, (), (), O>,
        now: Instant,
    ) {
        if self.lease.check_silence(since_start(now)) {
            self.connections.iter_mut().for_each(|connection| connection.lease = true);
            self.log(now, 3, "silent for too long, holds and rates end", None);
        }
        while let Some(change) = self.lease.next_ending() {
            // A change that was accepted under the lease can always be undone.
            let _ = runner.request(now, change.borrow());
        }
    }

    /// Counts a cycle and marks the data that are due after it.
    pub(crate) fn after_cycle(&mut self, now: Instant, late: u32) {
        self.next.time_us = now.as_micros();
        self.next.overruns = late.into();
        let clock = Instant::now();
        for connection in &mut self.connections {
            if connection.heard.is_some_and(|heard| clock.saturating_duration_since(heard) > IDLE) {
                *connection = Connection::new();
            }
            connection.mark_due(&self.next);
        }
        self.next.cycle += 1;
    }

    /// Answers a message that only a program on a computer offers.
    pub(crate) fn refuse_extra(&mut self) {
        let now = Instant::from_micros(self.next.time_us);
        self.log(now, 3, "refused: only a program on a computer offers this", None);
    }

    fn log(&mut self, now: Instant, level: u8, text: &'static str, component: Option<u16>) {
        for connection in &mut self.connections {
            connection.log(connection::LogEntry { time_us: now.as_micros(), level, text, component });
        }
    }

    /// Encodes the next packet of a connection; returns its length. `None` if there is none, or `room` is too small for it.
    pub(crate) fn next_packet(
        &mut self,
        line: Line,
        tree: &Forward,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        let context = packets::Context {
            tree,
            next: &self.next,
            lease: self.lease.state(line.id(), Instant::from_micros(self.next.time_us)),
            realtime: self.realtime,
            silence_ms: SILENCE.as_millis() as u32,
        };
        self.connections[line as usize].next_packet(&context, encoder, room)
    }
}

/// Time by which the operator's silence is measured.
const fn since_start(now: Instant) -> Duration {
    Duration::from_micros(now.as_micros())
}

/// Returns the component of a change, and a line of the log for it if it is applied and if it is refused.
fn describe_change(change: &Change) -> (Option<u16>, &'static str, &'static str) {
    let number = |component: &ComponentId| Some(component.index() as u16);
    match change {
        Change::Hold { component, .. } => (number(component), "hold", "refused: hold"),
        Change::Rate { component, .. } => (number(component), "rate", "refused: rate"),
        Change::Params(batch) => (batch.first().map(|setting| setting.component.index() as u16), "set", "refused: set"),
        Change::Modulate { component, .. } => (number(component), "call", "refused: call"),
        Change::World { .. } => (None, "", "refused: no world"),
    }
}
