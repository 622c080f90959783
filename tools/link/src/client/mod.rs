//! The monitor's end of the link.

mod event;
mod events;
mod extras;
mod inbox;
mod options;
mod scene;
mod wait;
mod watch;
mod world;

use std::collections::HashMap;
use std::thread;
use std::time::{Duration, Instant};

use bica_wire::message::{
    ExtraKind, FromMonitorExtra, LeaseAction, LeaseState, MAX_ARGUMENTS, MAX_BATCH, Offers, Request, Watch,
};
use bica_wire::{FromMonitor, SCHEMA};

use crate::address::Address;
use crate::error::Error;
use crate::frame::{Packets, Receiver};
use crate::stream::{Reading, Stream};
use bica_wire::model::{Description, Invalid};
use inbox::Inbox;

pub use event::{Answered, Costs, Event, Snapshot, happened};
pub use options::ClientOptions;
pub use scene::{Shown, Truth};

/// Time between two messages to the robot, if there is nothing else to send.
const HEARTBEAT: Duration = Duration::from_millis(500);
/// Time after which a state of the lease with another owner counts as the answer: an earlier one may be an older state that
/// waited to be read.
const SETTLED: Duration = Duration::from_millis(100);
/// Time between two attempts to connect again.
const RETRY: Duration = Duration::from_millis(100);
/// Maximum duration of the attempts to continue a lease after a reconnection.
const CONTINUE: Duration = Duration::from_secs(2);

/// A monitor of a robot.
///
/// All work is done in the calls: a client that owns the lease and does not call [`poll`](Self::poll) for longer than the robot's
/// limit of silence loses the lease.
pub struct Client {
    address: Address,
    options: ClientOptions,
    stream: Stream,
    receiver: Receiver,
    packets: Packets,
    inbox: Inbox,
    sent: Instant,
    /// Time of the last message that kept the lease.
    kept: Instant,
    last_number: u32,
    /// Watched snapshots, outputs and other data, to watch them again after a reconnection.
    every: u16,
    outputs: HashMap<(u16, u16), u16>,
    extras: HashMap<ExtraKind, u16>,
}

impl Client {
    /// Connects to a robot, attaches, and receives the description with the current values of all parameters.
    ///
    /// # Errors
    /// [`Error::Connect`], [`Error::Schema`], [`Error::Timeout`], [`Error::Disconnected`], [`Error::Invalid`].
    pub fn connect(address: &Address, options: ClientOptions) -> Result<Self, Error> {
        let stream = address.connect(options.timeout)?;
        stream.set_write_timeout(options.timeout).map_err(|error| Error::connect(address, error))?;
        let mut client = Self {
            address: address.clone(),
            options,
            stream,
            receiver: Receiver::new(),
            packets: Packets::new(),
            inbox: Inbox::new(),
            sent: Instant::now(),
            kept: Instant::now(),
            last_number: 0,
            every: 0,
            outputs: HashMap::new(),
            extras: HashMap::new(),
        };
        client.attach()?;
        Ok(client)
    }

    fn attach(&mut self) -> Result<(), Error> {
        self.send(&FromMonitor::Attach)?;
        self.wait("attaching", |inbox| inbox.attached.as_ref().map(|attached| attached.schema))
            .and_then(|robot| if robot == SCHEMA { Ok(()) } else { Err(Error::Schema { robot }) })?;
        self.packets.push_describe().map_err(|_| Error::Invalid("a packet is too small"))?;
        self.flush()?;
        self.wait("its description", |inbox| inbox.is_described().then_some(()))?;
        self.send(&FromMonitor::ReadParams)?;
        self.wait("the values of its parameters", |inbox| (inbox.has_values() && inbox.has_schemas()).then_some(()))?;
        self.wait("the state of the lease", |inbox| inbox.lease.map(|_| ()))
    }

    /// Connects again after [`Error::Disconnected`], within `limit`. Watches what was watched before, and continues the
    /// lease if it has not ended. Requests that were not answered are not sent again.
    ///
    /// # Errors
    /// As [`connect`](Self::connect), or [`Error::OtherRobot`].
    pub fn reconnect(&mut self, limit: Duration) -> Result<(), Error> {
        let until = Instant::now() + limit;
        let mut next = loop {
            match Self::connect(&self.address, self.options) {
                Ok(next) => break next,
                Err(Error::Connect { .. } | Error::Disconnected(_) | Error::Timeout(_)) if Instant::now() < until => {
                    thread::sleep(RETRY);
                }
                Err(error) => return Err(error),
            }
        };
        let (expected, found) = (self.description(), next.description());
        if (&expected.name, &expected.hash) != (&found.name, &found.hash) {
            return Err(Error::OtherRobot { expected: expected.name.clone(), found: found.name.clone() });
        }
        let lease = self.lease();
        next.last_number = self.last_number;
        next.watch(self.every)?;
        for (&(component, output), &every) in &self.outputs {
            next.watch_output(component.into(), output.into(), every)?;
        }
        for (&kind, &every) in &self.extras {
            next.watch_extra(kind, every)?;
        }
        if lease.yours {
            next.continue_lease(lease.lease)?;
        }
        *self = next;
        Ok(())
    }

    /// Continues the lease of a connection that has ended. The robot may not have noticed the end yet.
    fn continue_lease(&mut self, number: u64) -> Result<(), Error> {
        let until = Instant::now() + CONTINUE;
        loop {
            self.inbox.lease = None;
            self.send(&FromMonitor::Lease(LeaseAction::Keep { lease: number }))?;
            let lease = self.wait("the state of the lease", |inbox| inbox.lease)?;
            if lease.yours || !lease.owned || Instant::now() > until {
                return Ok(());
            }
            thread::sleep(RETRY);
        }
    }

    /// Returns the description. Values of parameters are those that the robot reported last.
    #[must_use]
    pub const fn description(&self) -> &Description {
        &self.inbox.description
    }

    /// Returns the services that the robot's program offers.
    #[must_use]
    pub fn offers(&self) -> Offers {
        self.inbox.attached.as_ref().map(|attached| attached.offers).unwrap_or_default()
    }

    /// Returns whether the robot's time advances with the clock.
    #[must_use]
    pub fn is_realtime(&self) -> bool {
        self.inbox.attached.as_ref().is_some_and(|attached| attached.realtime)
    }

    /// Returns the lease as the robot reported it last.
    #[must_use]
    pub fn lease(&self) -> LeaseState {
        self.inbox.lease.unwrap_or_default()
    }

    /// Returns the number of damaged packets received.
    #[must_use]
    pub const fn damaged(&self) -> u32 {
        self.receiver.damaged()
    }

    /// Acquires the lease. `take` takes it also from its owner; only a person may decide that.
    ///
    /// # Errors
    /// [`Error::Lease`] if somebody else owns it; [`Error::NotOffered`] if monitors may only watch; [`Error::Timeout`],
    /// [`Error::Disconnected`].
    pub fn acquire(&mut self, take: bool) -> Result<(), Error> {
        if !self.offers().contains(Offers::OPERATE) {
            return Err(Error::NotOffered("to be operated: monitors may only watch"));
        }
        // The end of another owner's lease may arrive first; it is not the answer.
        let is_answer = |lease: &LeaseState| lease.yours || (lease.owned && !take);
        let began = Instant::now();
        loop {
            self.inbox.lease = None;
            self.send(&FromMonitor::Lease(if take { LeaseAction::Take } else { LeaseAction::Acquire }))?;
            return match self.wait("the lease", |inbox| inbox.lease.filter(is_answer)) {
                Ok(lease) if lease.yours => Ok(()),
                Ok(_) if began.elapsed() < SETTLED => {
                    std::thread::sleep(SETTLED / 10);
                    continue;
                }
                Err(Error::Timeout(what)) if self.inbox.lease.is_none() => Err(Error::Timeout(what)),
                Ok(_) | Err(Error::Timeout(_)) => Err(Error::Lease),
                Err(error) => Err(error),
            };
        }
    }

    /// Gives the lease back and waits for the confirmation: then holds and rates have ended.
    ///
    /// # Errors
    /// [`Error::Timeout`], [`Error::Disconnected`].
    pub fn release(&mut self) -> Result<(), Error> {
        let lease = self.lease();
        if !lease.yours {
            return Ok(());
        }
        self.send(&FromMonitor::Lease(LeaseAction::Return { lease: lease.lease }))?;
        self.wait("the end of the lease", |inbox| inbox.lease.filter(|lease| !lease.yours).map(|_| ()))
    }

    /// Sends an action on the lease; the new state follows as [`Event::Lease`].
    ///
    /// # Errors
    /// [`Error::Disconnected`].
    pub fn send_lease(&mut self, action: LeaseAction) -> Result<(), Error> {
        self.send(&FromMonitor::Lease(action))
    }

    /// Sends a request and returns its number; the answer follows as [`Event::Answer`].
    ///
    /// # Errors
    /// [`Error::Unknown`] if it has too many values, [`Error::Disconnected`].
    pub fn send_request(&mut self, request: bica::runner::Request<'_>) -> Result<u32, Error> {
        let (lease, expires_us) = (self.lease().lease, self.expires_us());
        self.send_request_with(request, lease, expires_us)
    }

    /// Returns the robot's time after which a request that is sent now is refused, µs.
    fn expires_us(&self) -> u64 {
        let expiry = |time: Duration| u64::try_from((time + self.options.expiry).as_micros()).unwrap_or(u64::MAX);
        self.inbox.robot_time().map_or(u64::MAX, expiry)
    }

    /// Sends a request with the number of a lease and an expiry in the robot's time, µs; returns its number.
    ///
    /// # Errors
    /// [`Error::Unknown`] if it has too many values, [`Error::Disconnected`].
    pub fn send_request_with(
        &mut self,
        request: bica::runner::Request<'_>,
        lease: u64,
        expires_us: u64,
    ) -> Result<u32, Error> {
        let change = request.store().ok_or_else(|| {
            let help = format!("set at most {MAX_BATCH} at a time, and call with at most {MAX_ARGUMENTS} arguments");
            Invalid::new("these are too many values for one request", help)
        })?;
        self.last_number = self.last_number.wrapping_add(1);
        let number = self.last_number;
        self.send(&FromMonitor::Request(Request { number, lease, expires_us, change }))?;
        Ok(number)
    }

    /// Sends a request and waits for its answer.
    ///
    /// # Errors
    /// [`Error::Refused`], [`Error::Timeout`], [`Error::Disconnected`].
    pub fn request(&mut self, request: bica::runner::Request<'_>) -> Result<Answered, Error> {
        let number = self.send_request(request)?;
        self.answer(number)
    }

    /// Waits for the answer to a request.
    ///
    /// # Errors
    /// [`Error::Refused`], [`Error::Timeout`], [`Error::Disconnected`].
    pub fn answer(&mut self, number: u32) -> Result<Answered, Error> {
        let answer = self.wait("the answer to a request", |inbox| inbox.events.take_answer(number))?;
        answer.result()
    }

    /// Stops the robot: calls all of its stops, for which it needs no lease, and waits until they are in force. The stop ends the
    /// lease of any operator.
    ///
    /// # Errors
    /// [`Error::Unknown`] if the robot declares no stop; [`Error::Refused`] if its program accepts no requests; [`Error::Timeout`],
    /// [`Error::Disconnected`].
    pub fn stop(&mut self) -> Result<Vec<Answered>, Error> {
        let stops: Vec<_> = self.description().stops().collect();
        if stops.is_empty() {
            let what = format!("`{}` declares no stop", self.description().name);
            return Err(Invalid::new(what, "mark a modulation that stops it with `#[modulation(stop)]`").into());
        }
        let numbers = stops.iter().map(|stop| self.send_request(stop.borrow())).collect::<Result<Vec<_>, _>>()?;
        numbers.into_iter().map(|number| self.answer(number)).collect()
    }

    /// Waits for the next event; `None` after `timeout`.
    ///
    /// # Errors
    /// [`Error::Disconnected`]; then [`reconnect`](Self::reconnect).
    pub fn poll(&mut self, timeout: Duration) -> Result<Option<Event>, Error> {
        let until = Instant::now() + timeout;
        loop {
            let event = self.next_event()?;
            if event.is_some() || !self.receive(until)? {
                return Ok(event);
            }
        }
    }

    fn next_event(&mut self) -> Result<Option<Event>, Error> {
        let event = self.inbox.events.pop();
        if let Some(Event::Image(image)) = &event {
            self.send_extra(FromMonitorExtra::ImageTaken { number: image.number })?;
        }
        Ok(event)
    }

    /// Receives until `found` returns a value. Events that come meanwhile stay for [`poll`](Self::poll).
    fn wait<T>(&mut self, what: &'static str, mut found: impl FnMut(&mut Inbox) -> Option<T>) -> Result<T, Error> {
        let until = Instant::now() + self.options.timeout;
        loop {
            if let Some(value) = found(&mut self.inbox) {
                return Ok(value);
            }
            if !self.receive(until)? {
                return Err(Error::Timeout(what));
            }
        }
    }

    /// Reads once, at most until an instant; returns whether there is time left.
    fn receive(&mut self, until: Instant) -> Result<bool, Error> {
        let left = until.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Ok(false);
        }
        self.heartbeat()?;
        let cut = |error: std::io::Error| Error::Disconnected(error.to_string());
        self.stream.set_read_timeout(left.min(HEARTBEAT)).map_err(cut)?;
        let Self { inbox, receiver, stream, .. } = self;
        let mut result = Ok(());
        let reading = receiver.receive(stream, |packet| {
            if let (Ok(()), Ok(message)) = (&result, packet.message()) {
                result = inbox.receive(message);
            }
        });
        result?;
        match (reading.map_err(cut)?, inbox.closing.take()) {
            (_, Some(reason)) => Err(Error::Disconnected(reason)),
            (Reading::End, None) => Err(Error::Disconnected("the robot closed the connection".to_owned())),
            (Reading::Bytes(_) | Reading::Nothing, None) => Ok(true),
        }
    }

    /// Sends a sign of life if it is due.
    fn heartbeat(&mut self) -> Result<(), Error> {
        let lease = self.lease();
        // Other messages, such as changes of the watched data, do not keep the lease.
        if lease.yours && self.kept.elapsed() >= HEARTBEAT {
            self.kept = Instant::now();
            return self.send(&FromMonitor::Lease(LeaseAction::Keep { lease: lease.lease }));
        }
        if self.sent.elapsed() < HEARTBEAT {
            return Ok(());
        }
        self.send(&FromMonitor::Watch(Watch { every: self.every }))
    }

    fn send(&mut self, message: &FromMonitor) -> Result<(), Error> {
        self.packets.push_monitor(message).map_err(|_| Error::Invalid("a request does not fit into a packet"))?;
        self.flush()
    }

    fn send_extra(&mut self, message: FromMonitorExtra) -> Result<(), Error> {
        self.packets.push_monitor_extra(message).map_err(|_| Error::Invalid("a message does not fit into a packet"))?;
        self.flush()
    }

    fn flush(&mut self) -> Result<(), Error> {
        let cut = |error: std::io::Error| Error::Disconnected(error.to_string());
        self.sent = Instant::now();
        self.packets.write(&mut self.stream).map_err(cut)
    }
}
