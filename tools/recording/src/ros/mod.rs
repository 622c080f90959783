//! A robot in ROS 2: names, topics and messages, for recordings and for the node of the crate `bica-ros`.
//!
//! Each visual type has one message, whoever sends it. Messages are encoded in CDR as ROS does it: little-endian, without the header of
//! four bytes that [`CDR_LE`] is.

mod message;
mod names;
mod topics;

pub use message::*;
pub use names::{Names, checked_namespace, snake};
pub use topics::{Quality, Sent, Topic, Topics, parameter_value};
