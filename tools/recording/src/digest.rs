//! Digests of the values of a cycle.

use crate::message::Tick;
use crate::request::RequestRecord;

/// Returns the CRC-32 of the large data of a cycle, one after the other; 0 without any.
pub(crate) fn blobs_digest<'a>(blobs: impl Iterator<Item = &'a [u8]>) -> u32 {
    let mut hash = crc32fast::Hasher::new();
    blobs.for_each(|bytes| hash.update(bytes));
    hash.finalize()
}

/// Hash of all requests and ticks so far.
#[derive(Clone, Copy, Debug, Default)]
pub struct RunningFingerprint(Fnv);

impl RunningFingerprint {
    /// Adds a request.
    pub fn add_request(&mut self, request: &RequestRecord) {
        self.0.bytes(&postcard::to_stdvec(request).unwrap_or_default());
    }

    /// Adds a cycle; returns the fingerprint.
    pub fn add_tick(&mut self, tick: &Tick) -> u64 {
        self.0.bytes(&tick.cycle.to_le_bytes());
        self.0.bytes(&tick.instant.to_le_bytes());
        for digest in [tick.sensors, tick.blobs, tick.command, tick.tree] {
            self.0.bytes(&digest.to_le_bytes());
        }
        self.0.0
    }
}

/// FNV-1a hash of 64 bits (parameters of G. Fowler, L. Noll and K.-P. Vo).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fnv(
    /// The hash of the bytes so far.
    pub u64,
);

impl Default for Fnv {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv {
    /// Adds bytes.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}
