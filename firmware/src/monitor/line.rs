//! The line for monitors.

use core::task::Poll;

use bica_wire::{Decoder, Encoder, MAX_PACKET, ToRobot};
use embassy_futures::poll_once;
use embedded_io_async::{Read, Write};

use super::Line;
use crate::board::Board;
use crate::controller::Controller;

/// Size of the largest packet of a monitor, bytes: 32 settings.
const MAX_RECEIVED: usize = 512;
/// Largest number of bytes that are received at a time.
const RX_BYTES: usize = 64;
/// Largest number of bytes that are received in one call of [`MonitorLine::serve`]: 10 ms at 1 Mbit/s.
const MAX_RX_BYTES: usize = 1024;

/// Packets from and to the line for monitors.
pub(crate) struct MonitorLine {
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

impl MonitorLine {
    /// Creates a line on which nothing was received or sent.
    pub(crate) const fn new() -> Self {
        Self {
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

    /// Receives and sends without waiting: at most [`MAX_RX_BYTES`] and [`MAX_PACKET`] bytes. Returns whether there may be more.
    pub(crate) fn serve<B: Board>(
        &mut self,
        rx: &mut impl Read,
        tx: &mut impl Write,
        controller: &mut Controller<B>,
    ) -> bool {
        let was_empty = self.sent == self.length;
        if was_empty {
            (self.sent, self.length) = (0, 0);
        }
        let mut left = MAX_RX_BYTES / RX_BYTES;
        while self.handle(controller) && left > 0 {
            let Poll::Ready(Ok(count)) = poll_once(rx.read(&mut self.rx)) else { break };
            (self.received, self.handled, left) = (count, 0, left - 1);
        }
        let was_served = self.sent < self.length || left < MAX_RX_BYTES / RX_BYTES;
        // A snapshot is complete only if all its packets are encoded in one cycle, so they begin in an empty buffer.
        while was_empty && self.encode(controller) {}
        while self.sent < self.length {
            let Poll::Ready(Ok(count)) = poll_once(tx.write(&self.tx[self.sent..self.length])) else { break };
            self.sent += count;
        }
        was_served && self.sent == self.length
    }

    /// Handles the received bytes; returns whether all were handled. If there is no room for an answer, the remaining bytes wait.
    fn handle<B: Board>(&mut self, controller: &mut Controller<B>) -> bool {
        loop {
            if !controller.monitor().is_ready(Line::Monitor) && !self.encode(controller) {
                return false;
            }
            if self.handled == self.received {
                return true;
            }
            let byte = self.rx[self.handled];
            self.handled += 1;
            match self.decoder.push(byte).map(|packet| packet.message()) {
                Some(Ok(ToRobot::Describe)) => controller.monitor().describe(Line::Monitor),
                Some(Ok(ToRobot::Monitor(bytes))) => controller.receive_monitor(Line::Monitor, bytes),
                Some(Ok(ToRobot::MonitorExtra(_))) => controller.monitor().refuse_extra(),
                _ => {}
            }
        }
    }

    /// Encodes the next packet; returns whether a packet was due and fitted.
    fn encode<B: Board>(&mut self, controller: &mut Controller<B>) -> bool {
        let length = controller.next_packet(Line::Monitor, &mut self.encoder, &mut self.tx[self.length..]);
        self.length += length.unwrap_or(0);
        length.is_some()
    }
}
