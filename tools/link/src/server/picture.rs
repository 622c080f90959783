//! Camera images on their way to monitors.

use std::sync::Arc;

use bica_wire::message::ImageHead;
use bica_wire::{ToMonitorExtra, TooLarge, chunks};

use super::watcher::Watcher;
use crate::frame::Packets;

/// Size of the part of an image that is written before other messages have their turn, bytes.
const PART_BYTES: usize = 16 << 10;

/// A camera image in the sensor values of a robot.
#[derive(Clone, Copy, Debug)]
pub struct LinkImage<'a> {
    /// Name of its camera.
    pub camera: &'a str,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
    /// Pixels in YUYV, 2 bytes for each.
    pub yuyv: &'a [u8],
}

/// An image that is sent.
#[derive(Clone, Debug)]
pub(super) struct Picture {
    /// Number of the image since the start, from 0.
    pub(super) number: u32,
    /// Instant of the cycle that took it in, µs.
    pub(super) time_us: u64,
    pub(super) camera: Arc<str>,
    /// Width and height, px.
    pub(super) size: (u16, u16),
    pub(super) pixels: Arc<Vec<u8>>,
}

/// The newest image for the distributor, with the monitors at that time.
#[derive(Clone, Debug)]
pub(super) struct Shot {
    pub(super) watchers: Arc<[Watcher]>,
    pub(super) picture: Picture,
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

/// Memory for images whose owner is unknown.
#[derive(Debug, Default)]
pub(super) struct Copies(Vec<Arc<Vec<u8>>>);

impl Copies {
    /// Copies the pixels into memory that nobody uses any more.
    pub(super) fn copy(&mut self, yuyv: &[u8]) -> Arc<Vec<u8>> {
        let free = self.0.iter_mut().position(|copy| Arc::get_mut(copy).is_some());
        let mut copy = free.map_or_else(Arc::default, |free| self.0.swap_remove(free));
        // Nobody else has it, so this copies nothing.
        let pixels = Arc::make_mut(&mut copy);
        pixels.clear();
        pixels.extend_from_slice(yuyv);
        self.0.push(Arc::clone(&copy));
        copy
    }
}
