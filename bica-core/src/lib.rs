//! The framework: components, activation trees, rates, checks, state machines, probes.
#![no_std]

pub mod check;
pub mod component;
pub mod graph;
pub mod hold;
pub mod id;
pub mod probe;
pub mod rate;
pub mod render;
pub mod tree;

mod clock;
mod cycle;
mod engine;
mod loan;
mod set;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;

pub use component::{Component, Time};
pub use embassy_time::{Duration, Instant};
pub use graph::Graph;
pub use hold::Hold;
pub use id::ComponentId;
pub use probe::Probe;
pub use rate::Rate;
pub use tree::{Has, Tree};
