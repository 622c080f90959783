//! What robot and host say to each other over a serial line, and how it gets through.
//!
//! A *message* ([`ToRobot`], [`FromRobot`]) is data in postcard's format. A *packet* is a message with a running number
//! before it and a CRC-32 after it, freed of zero bytes (COBS) and ended by one. So a receiver finds the next packet
//! after any damage, notices every damaged and every missing one, and needs no memory but one packet's.
//!
//! ```
//! use bica_wire::{FromRobot, Receiver, Sender, SCHEMA, message::Greeting};
//!
//! let greeting = Greeting { schema: SCHEMA, name: "Forward", cycle_hz: 100.0, components: 25, fine_hz: 1, restarts: 0, reason: "" };
//! let (mut sender, mut receiver) = (Sender::new(), Receiver::<256>::new());
//! let mut room = [0; 256];
//! let packet = sender.pack(&FromRobot::Greeting(greeting.clone()), &mut room)?;
//! let mut heard = 0;
//! for &byte in packet {
//!     if let Some(message) = receiver.push(byte) {
//!         assert_eq!(message.read::<FromRobot>(), Ok(FromRobot::Greeting(greeting.clone())));
//!         heard += 1;
//!     }
//! }
//! assert_eq!(heard, 1);
//! # Ok::<(), bica_wire::TooLarge>(())
//! ```
//!
//! The robot speaks first: its greeting carries [`SCHEMA`], a number that two programs share only if they mean the same
//! by every byte. Asked to, it describes itself ([`describe()`]), so a monitor needs nothing generated from its sources.
#![no_std]

mod convert;
mod crc;
mod describe;
mod each;
mod frame;
pub mod message;
mod packet;
mod receiver;
mod schema;

pub use convert::NoCommand;
pub use crc::crc32;
pub use describe::describe;
pub use frame::{CHUNK, Frame, chunks};
pub use message::{FromRobot, ToRobot};
pub use packet::{MAX_PACKET, Sender, TooLarge};
pub use receiver::{Heard, Losses, NotUnderstood, Receiver};
pub use schema::SCHEMA;
