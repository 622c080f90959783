//! The same workloads with copper-rs: one application for each graph, described in `config/`.
//!
//! The set-up follows its documents and benchmarks: release build, default features, a graph in RON,
//! `run_one_iteration` on the started application. The log of messages and task states is off, which is its fastest
//! setting.
mod application;
mod task;

pub use application::{chain_3, chain_10, chain_100, diamond, forward};
pub use cu29::clock::{RobotClock, read_raw_counter};
