#![doc = include_str!("../README.md")]

mod body;
#[cfg(feature = "dds")]
mod dds;
mod driver;
mod ending;
mod firmware;
mod follow;
mod guard;
mod limiter;
mod measured;
pub mod message;
mod mode;
mod options;
mod phase;
mod rpc;
mod run;
mod start;
mod transport;
mod world;

use std::time::Duration;

pub use body::{Body, K1, T1};
#[cfg(feature = "dds")]
pub use dds::{Dds, address};
pub use driver::{Counts, Driver, Gait, Inputs, Outputs};
pub use firmware::Motion;
pub use guard::guard;
pub use limiter::Limiter;
pub use measured::{Mistake, is_lying, sensors};
pub use options::Options;
pub use rpc::{Answer, Calls, Mode, Request};
pub use transport::{Received, Transport};
pub use world::BoosterWorld;

/// Time from one cycle of the robot program to the next: 100 Hz, with which the gait was tuned.
pub const CYCLE: Duration = Duration::from_millis(10);
