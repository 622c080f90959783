//! A server for monitors without heap, threads or queues of packets.

use core::ops::DerefMut;
use core::time::Duration;

use bica_core::{ComponentId, Instant, Refusal, Tree};
use bica_runner::{Observer, Robot, Runner};

use super::connection::{Connection, LogEntry, REFUSED};
use super::lease::Lease;
use super::packets::Context;
use super::refusal::{Outcome, PendingAnswer};
use crate::message::{Change, CycleInfo, LeaseAction, RefusalCode, Request};
use crate::{Encoder, FromMonitor, ToRobot, read};

/// Silence of the operator after which the lease ends.
const SILENCE: Duration = Duration::from_secs(3);
/// Silence of a monitor after which nothing is sent to it any more.
const IDLE: bica_core::Duration = bica_core::Duration::from_secs(30);

/// A tree that runs and accepts requests: a [`Runner`], or a tree that a program ticks itself.
pub trait Operated {
    /// The tree.
    type Tree: Tree;

    /// Returns the tree.
    fn tree(&self) -> &Self::Tree;

    /// Applies a request between two cycles.
    ///
    /// # Errors
    /// If the tree refuses it; then nothing changes.
    fn request(&mut self, now: Instant, request: bica_runner::Request<'_>) -> Result<(), Refusal>;
}

impl<P, W, Q, O> Operated for Runner<P, W, Q, O>
where
    P: DerefMut<Target: Robot>,
    O: Observer<P::Target>,
{
    type Tree = P::Target;

    fn tree(&self) -> &P::Target {
        self.robot()
    }

    fn request(&mut self, now: Instant, request: bica_runner::Request<'_>) -> Result<(), Refusal> {
        Self::request(self, now, request)
    }
}

impl<T: Tree> Operated for &mut T {
    type Tree = T;

    fn tree(&self) -> &T {
        self
    }

    fn request(&mut self, _now: Instant, request: bica_runner::Request<'_>) -> Result<(), Refusal> {
        request.apply(&mut **self)
    }
}

/// Times and a random number for the handling of messages.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    /// The robot's time; `None` before the first cycle can run, when the lease is not available.
    pub robot: Option<Instant>,
    /// Time of a clock that always runs.
    pub clock: Instant,
    /// A number that is hard to guess, such as the count of a fast clock. It becomes the number of a new lease.
    pub random: u64,
}

/// Server for the monitors of a robot, on a number of lines.
///
/// It follows the rules of `docs/link.md`. Its memory and its work in a cycle are bounded, because it has no queue of
/// packets. Each line has a connection, which stores which data are due. A packet is encoded when the line has room, with
/// the values of that time, so new values replace unsent ones. Only an answer is stored; until it is sent, no further
/// message of this line is handled.
///
/// A program calls [`before_cycle`](Self::before_cycle) and [`after_cycle`](Self::after_cycle) around each tick, and
/// between two ticks [`SerialLine::serve`](super::SerialLine::serve) for a line of its own, or
/// [`receive`](Self::receive) and [`next_packet`](Self::next_packet) for a line that it shares.
pub struct MonitorServer<const LINES: usize> {
    lease: Lease,
    connections: [Connection; LINES],
    /// Numbers of the next cycle.
    next: CycleInfo,
    /// Whether the robot's time advances with its clock.
    realtime: bool,
}

impl<const LINES: usize> MonitorServer<LINES> {
    /// Creates a server without monitors.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            lease: Lease::new(SILENCE),
            connections: [const { Connection::new() }; LINES],
            next: CycleInfo { cycle: 0, time_us: 0, sensed: 0, images: 0, overruns: 0 },
            realtime: false,
        }
    }

    /// Sets whether the robot's time advances with its clock.
    pub const fn set_realtime(&mut self, realtime: bool) {
        self.realtime = realtime;
    }

    /// Counts a set of sensor values.
    pub fn sensed(&mut self, has_image: bool) {
        self.next.sensed += 1;
        self.next.images += u64::from(has_image);
    }

    /// Returns whether messages of a line can be handled: its last answer was sent.
    #[must_use]
    pub const fn is_ready(&self, line: usize) -> bool {
        self.connections[line].answer.is_none()
    }

    /// Handles a message that came over a line. Messages of a body are ignored.
    pub fn receive<R: Operated>(&mut self, line: usize, message: &ToRobot<'_>, robot: &mut R, moment: &Moment) {
        match message {
            ToRobot::Describe => self.connections[line].begin(const { &R::Tree::GRAPH }, moment.clock),
            ToRobot::Monitor(bytes) => self.receive_monitor(line, bytes, robot, moment),
            ToRobot::MonitorExtra(_) => {
                let now = Instant::from_micros(self.next.time_us);
                self.log(now, REFUSED, "not offered", None);
            }
            _ => {}
        }
    }

    fn receive_monitor<R: Operated>(&mut self, line: usize, bytes: &[u8], robot: &mut R, moment: &Moment) {
        let Ok(message) = postcard::from_bytes::<FromMonitor>(bytes) else { return };
        let connection = &mut self.connections[line];
        connection.heard = Some(moment.clock);
        match message {
            FromMonitor::Attach => (connection.attached, connection.lease) = (true, true),
            FromMonitor::Watch(watch) => connection.every = watch.every,
            FromMonitor::WatchOutput(watch) => connection.watch(watch),
            FromMonitor::ReadParams => connection.add_params(0..R::Tree::COUNT as u16),
            FromMonitor::Lease(action) => self.act(line, action, moment),
            FromMonitor::Request(request) => self.request(line, request, robot, moment.robot),
        }
    }

    fn act(&mut self, line: usize, action: LeaseAction, moment: &Moment) {
        if let Some(now) = moment.robot {
            if self.lease.act(line as u64, action, since_start(now), moment.random) {
                self.announce_lease();
                return;
            }
            if matches!(action, LeaseAction::Keep { .. }) && self.lease.state(line as u64, now).yours {
                return;
            }
        }
        self.connections[line].lease = true;
    }

    /// Sends the lease to every monitor.
    fn announce_lease(&mut self) {
        self.connections.iter_mut().for_each(|connection| connection.lease = true);
    }

    #[expect(clippy::needless_pass_by_value, reason = "a reference takes 32 bytes more of flash")]
    fn request<R: Operated>(&mut self, line: usize, request: Request, robot: &mut R, now: Option<Instant>) {
        let graph = const { &R::Tree::GRAPH };
        let time = now.unwrap_or(Instant::MIN);
        let admitted = match now {
            Some(now) => self.lease.admit(line as u64, &request, graph, since_start(now), now),
            None if request.change.is_stop(graph) => Ok(()),
            None => Err(RefusalCode::NoLease),
        };
        let outcome = match admitted {
            Err(code) => Outcome::refused(code, 0, "", "", ""),
            Ok(()) => match self.apply(&request.change, robot, time) {
                Ok(()) => Outcome::Done(read::effective(robot.tree(), &request.change)),
                Err(refusal) => Outcome::of_refusal(&refusal),
            },
        };
        let (component, what) = describe_change(&request.change);
        let level = if matches!(outcome, Outcome::Done(_)) { 2 } else { REFUSED };
        self.log(time, level, what, component);
        let (number, cycle) = (request.number, self.next.cycle);
        self.connections[line].answer = Some(PendingAnswer { number, cycle, outcome });
    }

    fn apply<R: Operated>(&mut self, change: &Change, robot: &mut R, now: Instant) -> Result<(), Refusal> {
        robot.request(now, change.borrow())?;
        if self.lease.record(change, const { &R::Tree::GRAPH }) {
            self.announce_lease();
        }
        if let Change::Params(batch) = change {
            for setting in batch {
                let component = setting.component.index() as u16;
                self.connections.iter_mut().for_each(|connection| connection.add_params(component..component + 1));
            }
        }
        Ok(())
    }

    /// Ends the lease of a silent operator, and the holds and rates of the lease. Called before each cycle.
    pub fn before_cycle(&mut self, robot: &mut impl Operated, now: Instant) {
        if self.lease.check_silence(since_start(now)) {
            self.announce_lease();
            self.log(now, 3, "silent for too long, holds and rates end", None);
        }
        while let Some(change) = self.lease.next_ending() {
            // A change that was accepted under the lease can always be undone.
            let _ = robot.request(now, change.borrow());
        }
    }

    /// Counts a cycle and marks the data that are due after it. `overruns` is the number of skipped cycles since the start, and
    /// `clock` the time of the clock of [`Moment`].
    pub fn after_cycle(&mut self, now: Instant, clock: Instant, overruns: u64) {
        self.next.time_us = now.as_micros();
        self.next.overruns = overruns;
        for connection in &mut self.connections {
            if connection.heard.is_some_and(|heard| clock.saturating_duration_since(heard) > IDLE) {
                *connection = Connection::new();
            }
            connection.mark_due(&self.next);
        }
        self.next.cycle += 1;
    }

    fn log(&mut self, now: Instant, level: u8, text: &'static str, component: Option<ComponentId>) {
        for connection in &mut self.connections {
            connection.log(LogEntry { time_us: now.as_micros(), level, text, component });
        }
    }

    /// Encodes the next packet for a line; returns its length. `None` if there is none, or `room` is too small for it.
    pub fn next_packet(
        &mut self,
        line: usize,
        tree: &impl Tree,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        let context = Context {
            tree,
            next: &self.next,
            lease: self.lease.state(line as u64, Instant::from_micros(self.next.time_us)),
            realtime: self.realtime,
            silence_ms: SILENCE.as_millis() as u32,
        };
        self.connections[line].next_packet(&context, encoder, room)
    }
}

impl<const LINES: usize> Default for MonitorServer<LINES> {
    fn default() -> Self {
        Self::new()
    }
}

/// Time by which the operator's silence is measured.
const fn since_start(now: Instant) -> Duration {
    Duration::from_micros(now.as_micros())
}

/// Returns the component of a change, and its text for the log.
fn describe_change(change: &Change) -> (Option<ComponentId>, &'static str) {
    match change {
        Change::Hold { component, .. } => (Some(*component), "hold"),
        Change::Rate { component, .. } => (Some(*component), "rate"),
        Change::Params(batch) => (batch.first().map(|setting| setting.component), "set"),
        Change::Modulate { component, .. } => (Some(*component), "call"),
        Change::World { .. } => (None, "no world"),
        Change::Go { component, .. } => (Some(*component), "go"),
    }
}
