#![doc = include_str!("../README.md")]
#![cfg(feature = "dds")]

mod message;
mod node;

pub use bica_recording::ros::checked_namespace;
pub use node::{Options, Ros, bridge};
