//! Fingerprint of a game: equal for two games if all commands and ball positions are equal, bit for bit.

use bica_motion::robot::{CameraId, Command};
use bica_recording::Fnv;
use glam::Vec2;

/// Hash over commands and ball positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Fingerprint(Fnv);

impl Fingerprint {
    /// Adds a cycle.
    pub(crate) fn add(&mut self, command: &Command, ball: Vec2) {
        let joints = command.targets.0.iter().chain(&command.stiffness.0);
        for value in joints.chain(&ball.to_array()) {
            self.0.bytes(&value.to_bits().to_le_bytes());
        }
        self.0.bytes(&[u8::from(command.camera == CameraId::Bottom)]);
    }
}

impl std::fmt::Display for Fingerprint {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{:016x}", self.0.0)
    }
}
