//! Camera images on their way to monitors.

use std::sync::Arc;

use bica_wire::message::ImageHead;
use bica_wire::{ToMonitorExtra, TooLarge, chunks};

use crate::frame::Packets;

/// Size of the part of an image that is written before other messages are sent, bytes.
const PART_BYTES: usize = 16 << 10;

/// An image that is sent.
#[derive(Clone, Debug)]
pub(super) struct Picture {
    /// Number of the image since the start, from 0.
    pub(super) number: u32,
    /// Instant of the cycle that received it, µs.
    pub(super) time_us: u64,
    pub(super) camera: Arc<str>,
    /// Width and height, px.
    pub(super) size: (u16, u16),
    pub(super) pixels: Arc<Vec<u8>>,
}

/// An image of which a part was written.
pub(super) struct Sending {
    picture: Picture,
    next_chunk: usize,
}

impl Sending {
    pub(super) const fn new(picture: Picture) -> Self {
        Self { picture, next_chunk: 0 }
    }

    /// Appends the packets of the next part; returns whether it was the last one.
    pub(super) fn push_part(&mut self, packets: &mut Packets) -> Result<bool, TooLarge> {
        let Picture { number, time_us, camera, size: (width, height), pixels } = &self.picture;
        let (number, time_us, width, height) = (*number, *time_us, *width, *height);
        if self.next_chunk == 0 {
            packets.push_extra(&ToMonitorExtra::Image(ImageHead { number, time_us, camera, width, height }))?;
        }
        let mut rest = chunks(number, pixels).skip(self.next_chunk);
        let mut bytes = 0;
        while bytes < PART_BYTES {
            let Some(chunk) = rest.next() else { return Ok(true) };
            bytes += chunk.bytes.len();
            self.next_chunk += 1;
            packets.push_extra(&ToMonitorExtra::ImageChunk(chunk))?;
        }
        Ok(rest.next().is_none())
    }
}
