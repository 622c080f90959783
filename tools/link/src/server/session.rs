//! One monitor: the thread that reads its messages and the thread that writes to it.

use std::io;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread;
use std::time::{Duration, Instant};

use bica_wire::message::ExtraKind;
use bica_wire::{FromMonitor, FromMonitorExtra, Packet, ToMonitor, ToRobot};

use super::connection::Connection;
use super::counters::Counters;
use super::cycle_data::{Due, Part};
use super::hub::{Command, Hub, MAX_PENDING};
use super::key::Key;
use super::options::MAX_MONITORS;
use super::outbox::{Batch, Message};
use super::sending::Sending;
use crate::frame::{Packets, Receiver};
use crate::stream::{Reading, Stream};

/// Time between two checks whether the connection was closed.
const POLL: Duration = Duration::from_millis(100);
/// Longest time of one write. A monitor that reads nothing for so long is disconnected.
const WRITE: Duration = Duration::from_secs(10);
/// Silence after which a monitor is disconnected: its computer may have lost the network.
const IDLE: Duration = Duration::from_secs(30);
/// Longest time until the first message of a TCP connection. Before it, the connection takes no place of a monitor.
const FIRST: Duration = Duration::from_secs(2);
/// Number of bytes that are written together.
const WRITE_BYTES: usize = 1 << 16;

/// Serves one monitor until the connection ends.
pub(super) fn serve(hub: &Arc<Hub>, mut stream: Stream) -> io::Result<()> {
    stream.set_read_timeout(POLL)?;
    stream.set_write_timeout(WRITE)?;
    let writer = stream.try_clone()?;
    let connection = Arc::new(Connection::new(hub.next_id(), stream.try_clone()?, Arc::clone(&hub.counters)));
    hub.wait_for_message(&connection);
    let written = Arc::clone(&connection);
    let thread = thread::Builder::new().name("link writer".to_owned()).spawn(move || write(&written, writer))?;
    read(hub, &connection, &mut stream);
    connection.close();
    // A panic of the writer has printed its message.
    let _ = thread.join();
    Ok(())
}

/// Sends a monitor the reason why its connection is closed. Nothing was written to it yet, so this does not wait.
fn reject(stream: &mut Stream) {
    let mut packets = Packets::new();
    if packets.push(&ToMonitor::Closing { reason: "too many monitors are attached" }).is_ok() {
        // A monitor that is gone needs no reason.
        let _ = packets.write(stream);
    }
}

/// One of the places for monitors, occupied until this is dropped.
struct MonitorSlot(Arc<Counters>);

impl MonitorSlot {
    fn take(counters: &Arc<Counters>) -> Option<Self> {
        let more = |open| (open < MAX_MONITORS).then_some(open + 1);
        counters.open.fetch_update(Ordering::Relaxed, Ordering::Relaxed, more).ok()?;
        Some(Self(Arc::clone(counters)))
    }
}

impl Drop for MonitorSlot {
    fn drop(&mut self) {
        self.0.open.fetch_sub(1, Ordering::Relaxed);
    }
}

fn read(hub: &Arc<Hub>, connection: &Arc<Connection>, stream: &mut Stream) {
    // A serial line may begin with earlier bytes; only a program that a person has started opens it.
    let mut receiver = if stream.is_serial() { Receiver::new() } else { Receiver::strict() };
    let mut heard = Instant::now();
    let mut damaged = 0;
    let (mut slot, mut is_full) = (None, false);
    while !connection.is_closed() && !hub.stopped.load(Ordering::Relaxed) {
        let mut served = true;
        let reading = receiver.receive(stream, |packet| match decode(&packet) {
            Some(message) if !connection.is_closed() && !is_full => {
                heard = Instant::now();
                if slot.is_none() {
                    slot = MonitorSlot::take(&hub.counters);
                    is_full = slot.is_none();
                    if is_full {
                        return;
                    }
                    hub.begin(connection);
                }
                served &= handle(hub, connection, message);
            }
            Some(_) => {}
            None => {
                hub.counters.unknown.fetch_add(1, Ordering::Relaxed);
            }
        });
        hub.counters.damaged.fetch_add(receiver.damaged().wrapping_sub(damaged), Ordering::Relaxed);
        damaged = receiver.damaged();
        if is_full {
            hub.counters.rejected.fetch_add(1, Ordering::Relaxed);
            reject(stream);
            return;
        }
        let ended = matches!(reading, Ok(Reading::End) | Err(_));
        let longest = if slot.is_some() || stream.is_serial() { IDLE } else { FIRST };
        if ended || !served || heard.elapsed() > longest {
            return;
        }
    }
}

/// Message that a monitor may send.
enum Incoming {
    Describe,
    Monitor(Box<FromMonitor>),
    Extra(FromMonitorExtra),
}

fn decode(packet: &Packet<'_>) -> Option<Incoming> {
    match packet.message().ok()? {
        ToRobot::Describe => Some(Incoming::Describe),
        ToRobot::Monitor(bytes) => postcard::from_bytes(bytes).ok().map(|message| Incoming::Monitor(Box::new(message))),
        ToRobot::MonitorExtra(bytes) => postcard::from_bytes(bytes).ok().map(Incoming::Extra),
        _ => None,
    }
}

/// Handles a message; returns whether the loop still runs.
fn handle(hub: &Hub, connection: &Arc<Connection>, message: Incoming) -> bool {
    let command = match message {
        Incoming::Describe => {
            connection.push(Message::Describe(hub.graph, hub.options.actions, hub.messages));
            return true;
        }
        Incoming::Extra(FromMonitorExtra::ImageTaken { .. }) => {
            connection.image_taken();
            return true;
        }
        Incoming::Extra(FromMonitorExtra::World(request)) => Command::World(request),
        Incoming::Extra(FromMonitorExtra::Watch { kind: ExtraKind::Images, every }) => Command::WatchImages(every),
        Incoming::Extra(FromMonitorExtra::Watch { kind: ExtraKind::Taken, every }) => Command::WatchTaken(every > 0),
        Incoming::Extra(FromMonitorExtra::Watch { kind: ExtraKind::Stop(stop), every }) => {
            Command::Stop(stop, every > 0)
        }
        Incoming::Extra(FromMonitorExtra::Watch { kind, every }) => match Key::of_extra(kind, every) {
            Some(watch) => Command::WatchKey(watch),
            None => return true,
        },
        Incoming::Monitor(message) => match *message {
            FromMonitor::Attach => {
                connection.push(Message::Attached(hub.attached()));
                Command::Attach
            }
            FromMonitor::Watch(watch) => Command::Watch(watch),
            FromMonitor::WatchOutput(watch) => Command::WatchKey(Key::of_output(watch)),
            FromMonitor::ReadParams => Command::ReadParams,
            FromMonitor::Lease(action) => Command::Lease(action),
            FromMonitor::Request(request) => Command::Request(Box::new(request)),
        },
    };
    // A monitor that sends faster than the loop handles messages is slowed down; other monitors are not.
    while connection.pending.load(Ordering::Relaxed) >= MAX_PENDING {
        if connection.is_closed() || hub.stopped.load(Ordering::Relaxed) {
            return true;
        }
        thread::sleep(Duration::from_millis(1));
    }
    connection.pending.fetch_add(1, Ordering::Relaxed);
    hub.deliver(connection, command)
}

fn write(connection: &Connection, mut stream: Stream) {
    let mut packets = Packets::new();
    let mut sending: Option<Sending> = None;
    while let Some(Batch { mut waiting, data, image }) = connection.take(sending.is_some()) {
        let mut closing = false;
        while let Some(message) = waiting.message() {
            closing |= matches!(message, Message::Closing(_));
            // A message that does not fit into a packet is left out: the limits of the protocol exclude it.
            let _ = message.encode(&mut packets);
            if packets.len() > WRITE_BYTES && packets.write(&mut stream).is_err() {
                connection.close();
                return;
            }
        }
        let mut parts: Vec<_> = std::iter::from_fn(|| waiting.data()).collect();
        // The snapshot, which has the time of the cycle, comes first.
        parts.sort_by_key(Part::key);
        for part in parts.into_iter().chain(data.iter().flat_map(Due::parts)) {
            let _ = part.frame(&mut packets);
        }
        sending = sending.or_else(|| image.map(Sending::new));
        // Each part of an image comes after everything else, so an image delays nothing for long.
        sending.take_if(|sending| sending.push_part(&mut packets).unwrap_or(true));
        if packets.write(&mut stream).is_err() || closing {
            connection.close();
            return;
        }
    }
}
