//! The same work with copper-rs: an application for each graph, described in `config/`.
//!
//! As its documents and benchmarks do: release build, default features, a graph in RON, `run_one_iteration` on the
//! started application. Its log of messages and task states is off, which is the fastest that it goes.
mod application;
mod task;

pub use application::{chain_3, chain_10, chain_100, diamond, forward};
pub use cu29::clock::{RobotClock, read_raw_counter};
