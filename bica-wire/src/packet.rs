//! The layout of a packet.

/// Size of a buffer that holds any packet of this crate's messages, bytes.
pub const MAX_PACKET: usize = 1280;

/// Size of the sequence number before the message, bytes.
pub(crate) const SEQUENCE_BYTES: usize = 2;
/// Size of the CRC after the message, bytes.
pub(crate) const CRC_BYTES: usize = 4;
