//! Messages and packets between a robot, its host and its monitors over a byte stream: a serial line or TCP.
//!
//! A *message* ([`ToRobot`], [`FromRobot`]) is data in postcard's format. A *packet* is a sequence number, a message and
//! a CRC-32, encoded with COBS (consistent overhead byte stuffing), so that it contains no zero byte, and terminated by a
//! zero byte. A receiver therefore finds the next packet after any damage, detects every damaged and every missing
//! packet, and needs memory for one packet only.
//!
//! ```
//! use bica_wire::{Decoder, Encoder, FromRobot, message::StackUsage};
//!
//! let message = FromRobot::StackUsage(StackUsage { max_used: 4096, size: 65536 });
//! let (mut encoder, mut decoder) = (Encoder::new(), Decoder::<256>::new());
//! let mut buffer = [0; 256];
//! let packet = encoder.encode(&message, &mut buffer)?;
//! let mut received = 0;
//! for &byte in packet {
//!     if let Some(packet) = decoder.push(byte) {
//!         assert_eq!(packet.message::<FromRobot>().as_ref(), Ok(&message));
//!         received += 1;
//!     }
//! }
//! assert_eq!(received, 1);
//! # Ok::<(), bica_wire::TooLarge>(())
//! ```
//!
//! The robot sends first: its [`message::Identity`] carries [`SCHEMA`], a hash of all message types. Two programs
//! understand each other if and only if their hashes are equal. On request the robot sends the graph of its tree
//! ([`describe()`]), so a monitor needs no code generated from the robot's sources.
//!
//! Two kinds of programs send to a robot. The *host* is the body or the world: [`message::Hello`], sensor values, images. A
//! *monitor* attaches without changing anything, watches, and requests changes while it owns the lease. The page
//! `docs/link.md` describes its protocol.
//!
//! [`server`] is the robot's end of that protocol. With the feature `monitor` it contains a server without heap for any
//! tree. With the feature `std`, [`model`] is the description of a robot that every tool reads.
#![no_std]

#[cfg(feature = "std")]
extern crate std;

pub mod blobs;
mod crc;
mod decoder;
mod describe;
mod encoder;
mod image;
pub mod message;
#[cfg(feature = "std")]
pub mod model;
mod packet;
pub mod read;
mod recordable;
mod schema;
pub mod server;
mod text;

pub use crc::crc32;
pub use decoder::{Decoder, Packet, UnknownMessage};
pub use describe::{GraphItems, describe};
pub use encoder::{Encoder, TooLarge, encode};
pub use image::{CHUNK_BYTES, ImageAssembler, ImageBuffer, chunks};
pub use message::{FromMonitor, FromMonitorExtra, FromRobot, ToMonitor, ToMonitorExtra, ToRobot};
pub use packet::MAX_PACKET;
pub use recordable::{Recordable, messages_hash};
pub use schema::SCHEMA;
pub use text::truncate;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
