//! A robot in ROS 2: names, topics and messages, for recordings and for the node of the crate `bica-ros`.
//!
//! Each visual type has one type of message, for all senders. Messages are encoded in CDR as in ROS: little-endian, without the
//! four bytes of the header [`CDR_LE`].

mod message;
mod names;
mod topics;

pub use message::*;
pub use names::{Names, checked_namespace, snake};
pub use topics::{Quality, Sent, Topic, Topics, parameter_value};
