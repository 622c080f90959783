//! The robot's end of a link to monitors, without what depends on the platform: threads, queues, lines.
//!
//! A server on a computer and one on a microcontroller follow the same rules, because both consist of these parts. A
//! server passes messages to the [`Lease`], which decides who may request what and what ends with it. [`read`] reads
//! answers, states and parameters out of the tree after the cycle.

mod component_set;
mod lease;
pub mod read;

pub use lease::Lease;
