//! Packets of a camera image.

use bica_wire::message::ImageHead;
use bica_wire::{ToMonitorExtra, TooLarge, chunks};

use crate::frame::Packets;
use crate::image::Image;

/// Size of the part of an image that is written before other messages are sent, bytes.
const PART_BYTES: usize = 16 << 10;

/// An image of which a part was written.
pub(super) struct Sending {
    image: Image,
    next_chunk: usize,
}

impl Sending {
    pub(super) const fn new(image: Image) -> Self {
        Self { image, next_chunk: 0 }
    }

    /// Appends the packets of the next part; returns whether it was the last one.
    pub(super) fn push_part(&mut self, packets: &mut Packets) -> Result<bool, TooLarge> {
        let Image { number, time_us, ref camera, width, height, ref yuyv } = self.image;
        if self.next_chunk == 0 {
            packets.push_extra(&ToMonitorExtra::Image(ImageHead { number, time_us, camera, width, height }))?;
        }
        let mut rest = chunks(number, yuyv).skip(self.next_chunk);
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
