//! The robot's end of a link to monitors, without the parts that depend on the platform: threads, clocks, lines.
//!
//! The [`Lease`] decides which requests are admitted and which changes end with it; every server uses it. [`MonitorServer`] is
//! the complete server of a program without heap and threads. The [messages](crate::message) do not depend on this module.

mod component_set;
#[cfg(feature = "monitor")]
mod connection;
mod lease;
#[cfg(feature = "monitor")]
mod monitor_server;
#[cfg(feature = "monitor")]
mod output;
#[cfg(feature = "monitor")]
mod packets;
#[cfg(feature = "monitor")]
mod refusal;
#[cfg(feature = "monitor")]
mod serial_line;

pub use lease::Lease;
#[cfg(feature = "monitor")]
pub use monitor_server::{Moment, MonitorServer, Operated};
#[cfg(feature = "monitor")]
pub use serial_line::SerialLine;
