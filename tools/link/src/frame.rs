//! Packets on a byte stream.

use std::io;

use bica_wire::{
    Decoder, Encoder, FromMonitor, FromMonitorExtra, FromRobot, MAX_PACKET, Packet, ToMonitor, ToMonitorExtra, ToRobot,
    TooLarge,
};
use serde::Serialize;

use crate::stream::{Reading, Stream};

/// Size of the buffer for received bytes.
const BUFFER: usize = 4096;

/// Receiver of packets.
pub(crate) struct Receiver {
    decoder: Box<Decoder<MAX_PACKET>>,
    buffer: Box<[u8; BUFFER]>,
    /// Whether the stream ends if it begins with anything but a packet.
    is_strict: bool,
}

impl Receiver {
    pub(crate) fn new() -> Self {
        Self { decoder: Box::default(), buffer: Box::new([0; BUFFER]), is_strict: false }
    }

    /// Creates a receiver of a stream that must begin with an undamaged packet. A web page can make a browser send any bytes to
    /// any address, but only after the head of a request or of a handshake.
    pub(crate) fn strict() -> Self {
        Self { is_strict: true, ..Self::new() }
    }

    /// Reads once and passes each undamaged packet to `handle`. A strict stream that begins with something else is at its end.
    pub(crate) fn receive(&mut self, stream: &mut Stream, mut handle: impl FnMut(Packet<'_>)) -> io::Result<Reading> {
        let reading = stream.read(&mut *self.buffer)?;
        if let Reading::Bytes(count) = reading {
            for &byte in &self.buffer[..count] {
                if let Some(packet) = self.decoder.push(byte) {
                    self.is_strict = false;
                    handle(packet);
                } else if self.is_strict && self.decoder.stats().damaged > 0 {
                    return Ok(Reading::End);
                }
            }
        }
        Ok(reading)
    }

    /// Number of damaged packets, noise included.
    pub(crate) const fn damaged(&self) -> u32 {
        self.decoder.stats().damaged
    }
}

/// Encoder of packets that follow each other in one buffer.
pub(crate) struct Packets {
    encoder: Encoder,
    packet: Box<[u8; MAX_PACKET]>,
    bytes: Vec<u8>,
}

impl Packets {
    pub(crate) fn new() -> Self {
        Self { encoder: Encoder::new(), packet: Box::new([0; MAX_PACKET]), bytes: Vec::new() }
    }

    /// Appends a message to a monitor.
    pub(crate) fn push(&mut self, message: &ToMonitor<'_>) -> Result<(), TooLarge> {
        let bytes = postcard::to_stdvec(message).map_err(|_| TooLarge)?;
        self.push_robot(&FromRobot::Monitor(&bytes))
    }

    /// Appends a message to a monitor that only a program on a computer sends.
    pub(crate) fn push_extra(&mut self, message: &ToMonitorExtra<'_>) -> Result<(), TooLarge> {
        let bytes = postcard::to_stdvec(message).map_err(|_| TooLarge)?;
        self.push_robot(&FromRobot::MonitorExtra(&bytes))
    }

    /// Appends a message of a robot.
    pub(crate) fn push_robot(&mut self, message: &FromRobot<'_>) -> Result<(), TooLarge> {
        self.encode(message)
    }

    /// Appends a message of a monitor.
    pub(crate) fn push_monitor(&mut self, message: &FromMonitor) -> Result<(), TooLarge> {
        let bytes = postcard::to_stdvec(message).map_err(|_| TooLarge)?;
        self.encode(&ToRobot::Monitor(&bytes))
    }

    /// Appends a message of a monitor about a service that only a program on a computer offers.
    pub(crate) fn push_monitor_extra(&mut self, message: FromMonitorExtra) -> Result<(), TooLarge> {
        let bytes = postcard::to_stdvec(&message).map_err(|_| TooLarge)?;
        self.encode(&ToRobot::MonitorExtra(&bytes))
    }

    /// Appends the request for a description.
    pub(crate) fn push_describe(&mut self) -> Result<(), TooLarge> {
        self.encode(&ToRobot::Describe)
    }

    fn encode(&mut self, message: &impl Serialize) -> Result<(), TooLarge> {
        let packet = self.encoder.encode(message, &mut *self.packet)?;
        self.bytes.extend_from_slice(packet);
        Ok(())
    }

    /// Returns the number of bytes that wait.
    pub(crate) const fn len(&self) -> usize {
        self.bytes.len()
    }

    /// Writes all packets.
    pub(crate) fn write(&mut self, stream: &mut Stream) -> io::Result<()> {
        let written = stream.write_all(&self.bytes);
        self.bytes.clear();
        written
    }
}
