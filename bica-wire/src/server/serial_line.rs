//! A line that belongs to one monitor.

use super::monitor_server::{Moment, MonitorServer, Operated};
use crate::{Decoder, Encoder, MAX_PACKET, ToRobot};

/// Size of the largest packet of a monitor, bytes: 32 settings.
const MAX_RECEIVED: usize = 512;
/// Largest number of bytes that are received at a time.
const RX_BYTES: usize = 64;
/// Largest number of bytes that are received in one call of [`SerialLine::serve`]: 10 ms at 1 Mbit/s.
const MAX_RX_BYTES: usize = 1024;

/// Packets from and to a line that belongs to one monitor.
pub struct SerialLine {
    /// Number of the line.
    line: usize,
    decoder: Decoder<MAX_RECEIVED>,
    encoder: Encoder,
    /// Bytes that were received and not handled yet: those from `handled` to `received`.
    rx: [u8; RX_BYTES],
    received: usize,
    handled: usize,
    /// Packets that are being sent: the bytes from `sent` to `length`.
    tx: [u8; MAX_PACKET],
    length: usize,
    sent: usize,
}

impl SerialLine {
    /// Creates the line with this number in the server. Nothing has been received or sent on it.
    #[must_use]
    pub const fn new(line: usize) -> Self {
        Self {
            line,
            decoder: Decoder::new(),
            encoder: Encoder::new(),
            rx: [0; RX_BYTES],
            received: 0,
            handled: 0,
            tx: [0; MAX_PACKET],
            length: 0,
            sent: 0,
        }
    }

    /// Receives at most 1024 bytes and sends at most [`MAX_PACKET`] bytes, without waiting. Returns whether there may be more.
    ///
    /// `read` fills a part of its room and returns the number of bytes, 0 if none has come. `write` returns the number of
    /// bytes that it accepted, 0 if the line is busy.
    pub fn serve<const LINES: usize>(
        &mut self,
        mut read: impl FnMut(&mut [u8]) -> usize,
        mut write: impl FnMut(&[u8]) -> usize,
        server: &mut MonitorServer<LINES>,
        robot: &mut impl Operated,
        moment: &Moment,
    ) -> bool {
        let was_empty = self.sent == self.length;
        if was_empty {
            (self.sent, self.length) = (0, 0);
        }
        let mut left = MAX_RX_BYTES / RX_BYTES;
        while self.handle(server, robot, moment) && left > 0 {
            (self.received, self.handled) = (read(&mut self.rx), 0);
            if self.received == 0 {
                break;
            }
            left -= 1;
        }
        let was_served = self.sent < self.length || left < MAX_RX_BYTES / RX_BYTES;
        // A snapshot is complete only if all its packets are encoded in one cycle, so they begin in an empty buffer.
        while was_empty && self.encode(server, robot) {}
        while self.sent < self.length {
            match write(&self.tx[self.sent..self.length]) {
                0 => break,
                count => self.sent += count,
            }
        }
        was_served && self.sent == self.length
    }

    /// Handles the received bytes; returns whether all were handled. If there is no room for an answer, the remaining bytes wait.
    fn handle<const LINES: usize>(
        &mut self,
        server: &mut MonitorServer<LINES>,
        robot: &mut impl Operated,
        moment: &Moment,
    ) -> bool {
        loop {
            if !server.is_ready(self.line) && !self.encode(server, robot) {
                return false;
            }
            if self.handled == self.received {
                return true;
            }
            let byte = self.rx[self.handled];
            self.handled += 1;
            if let Some(Ok(message)) = self.decoder.push(byte).map(|packet| packet.message::<ToRobot<'_>>()) {
                server.receive(self.line, &message, robot, moment);
            }
        }
    }

    /// Encodes the next packet; returns whether a packet was due and fitted.
    fn encode<const LINES: usize>(&mut self, server: &mut MonitorServer<LINES>, robot: &impl Operated) -> bool {
        let room = &mut self.tx[self.length..];
        let length = server.next_packet(self.line, robot.tree(), &mut self.encoder, room);
        self.length += length.unwrap_or(0);
        length.is_some()
    }
}
