//! Start of a game, and identity of the robot.

use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// Start of a game.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Hello<'a> {
    /// The host's [`SCHEMA`](crate::SCHEMA). The robot starts no game with a host of another schema.
    pub schema: u64,
    /// The host's [`messages_hash`](crate::messages_hash), which has to be the robot's, too.
    pub messages: u64,
    /// The clock that ticks the tree.
    pub clock_mode: ClockMode,
    /// Data that the robot's program needs before the start, in a format of its own.
    pub set_up: &'a [u8],
}

/// The clock that ticks the tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum ClockMode {
    /// The robot's own clock: the tree is ticked at its rate, with or without new sensor values.
    FreeRunning,
    /// The world's clock: the tree is ticked once for each [`Sensors`](super::Sensors) message, at the message's time.
    Lockstep,
}

/// Identity of the robot's program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Identity<'a> {
    /// The robot's [`SCHEMA`](crate::SCHEMA): the first field in every version
    /// ([`Packet::identity_schema`](crate::Packet::identity_schema)).
    pub schema: u64,
    /// The robot's [`messages_hash`](crate::messages_hash).
    pub messages: u64,
    /// Name of the tree.
    pub name: &'a str,
    /// Nominal tick rate of the tree, Hz.
    pub cycle_hz: f32,
    /// Number of components in the tree.
    pub components: u8,
    /// Rate of the counter that measures costs, Hz.
    pub counter_hz: u32,
    /// Maximum size of the large data of a message, bytes. Larger data count as incomplete.
    pub image_bytes: u32,
    /// Number of restarts after a panic since power-on.
    pub restarts: u32,
    /// Message of the last panic since power-on; empty without one.
    pub last_panic: &'a str,
}
