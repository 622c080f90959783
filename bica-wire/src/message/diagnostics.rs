//! Measurements on the robot's program, and faults injected into it.

use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// Report of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Telemetry<'a> {
    /// Time of the cycle, µs.
    pub time_us: u64,
    /// Whether the robot is in the safe stop because it received nothing for too long.
    pub safe_stop: bool,
    /// Number of skipped cycles since the last start. A cycle is skipped if the one before it ends too late.
    pub late_cycles: u32,
    /// Number of images with a missing chunk.
    pub incomplete_images: u32,
    /// Packets received by the robot.
    pub link: LinkStats,
    /// Duration of the sense-think-act chain, counter ticks.
    pub chain_ticks: u32,
    /// One bit for each component: whether it is active.
    pub active: u64,
    /// One byte for each component: the index of its current state, 255 without a state machine.
    pub states: &'a [u8],
    /// Four bytes for each component, little-endian; [`Self::component_ticks`] decodes them.
    pub component_ticks: &'a [u8],
}

impl Telemetry<'_> {
    /// Returns the time that each component spent in its own code in this cycle, counter ticks, in the order of the
    /// tree's list.
    pub fn component_ticks(&self) -> impl Iterator<Item = u32> + '_ {
        self.component_ticks.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes))
    }
}

/// Packet counts of a receiver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct LinkStats {
    /// Number of undamaged packets received.
    pub received: u32,
    /// Number of damaged packets, noise included.
    pub damaged: u32,
    /// Number of packets missing, counted by gaps in the sequence numbers. A damaged packet leaves a gap too.
    pub missing: u32,
}

/// Use of the stack since the last start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct StackUsage {
    /// Maximum used, bytes.
    pub max_used: u32,
    /// Size of the stack, bytes.
    pub size: u32,
}

/// A fault, injected to test the robot's reaction. Only images built with fault injection apply it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum FaultInjection {
    /// Delays each run of a component.
    Delay {
        /// Index of the component in the tree's list.
        component: u8,
        /// Delay, counter ticks; 0 removes the fault.
        ticks: u32,
    },
    /// Makes a component panic in its next run.
    Panic {
        /// Index of the component in the tree's list.
        component: u8,
    },
}
