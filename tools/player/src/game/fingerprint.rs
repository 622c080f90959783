//! Fingerprint of a game: equal for two games if all commands and ball positions are equal, bit for bit.

use bica_motion::robot::{CameraId, Command};
use glam::Vec2;

/// FNV-1a hash of 64 bits (parameters of G. Fowler, L. Noll and K.-P. Vo) over commands and ball positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fingerprint(u64);

impl Fingerprint {
    /// Creates the fingerprint of a game without cycles.
    pub(crate) const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Adds a cycle.
    pub(crate) fn add(&mut self, command: &Command, ball: Vec2) {
        let joints = command.targets.0.iter().chain(&command.stiffness.0);
        for value in joints.chain(&ball.to_array()) {
            self.bytes(&value.to_bits().to_le_bytes());
        }
        self.bytes(&[u8::from(command.camera == CameraId::Bottom)]);
    }

    fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}

impl std::fmt::Display for Fingerprint {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{:016x}", self.0)
    }
}
