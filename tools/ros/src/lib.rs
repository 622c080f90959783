#![doc = include_str!("../README.md")]
#![cfg(feature = "dds")]

mod bag;
mod message;
mod names;
mod node;
mod topics;

pub use bag::bag;
pub use names::checked_namespace;
pub use node::{Options, Ros, bridge};
