//! Digests of the values of a cycle.

use bica_wire::message::{Command, Sensors};
use serde::Serialize;

use crate::message::Tick;
use crate::request::RequestRecord;

/// Returns the CRC-32 of sensor values without their image.
#[must_use]
pub fn sensors_digest(sensors: &Sensors) -> u32 {
    digest(&Sensors { image: None, ..*sensors })
}

/// Returns the CRC-32 of a command.
#[must_use]
pub fn command_digest(command: &Command) -> u32 {
    digest(command)
}

/// Returns the CRC-32 of an image: camera, size and pixels (YUYV).
#[must_use]
pub fn image_digest(bottom_camera: bool, width: u16, height: u16, yuyv: &[u8]) -> u32 {
    let mut hash = crc32fast::Hasher::new();
    hash.update(&[u8::from(bottom_camera)]);
    hash.update(&width.to_le_bytes());
    hash.update(&height.to_le_bytes());
    hash.update(yuyv);
    hash.finalize()
}

fn digest(value: &impl Serialize) -> u32 {
    let mut buffer = [0; 1024];
    // The messages of a cycle are far smaller; one that is not gives the digest of nothing.
    crc32fast::hash(postcard::to_slice(value, &mut buffer).map_or(&[], |bytes| bytes))
}

/// Hash of all requests and ticks so far.
#[derive(Clone, Copy, Debug)]
pub struct RunningFingerprint(Fnv);

impl Default for RunningFingerprint {
    fn default() -> Self {
        Self(Fnv::new())
    }
}

impl RunningFingerprint {
    /// Adds a request.
    pub fn add_request(&mut self, request: &RequestRecord) {
        self.0.bytes(&postcard::to_stdvec(request).unwrap_or_default());
    }

    /// Adds a cycle; returns the fingerprint.
    pub fn add_tick(&mut self, tick: &Tick) -> u64 {
        self.0.bytes(&tick.cycle.to_le_bytes());
        self.0.bytes(&tick.instant.to_le_bytes());
        for digest in [tick.sensors, tick.image, tick.command, tick.tree] {
            self.0.bytes(&digest.to_le_bytes());
        }
        self.0.0
    }
}

/// FNV-1a hash of 64 bits (parameters of G. Fowler, L. Noll and K.-P. Vo).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Fnv(u64);

impl Fnv {
    const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}
