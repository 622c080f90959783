//! The framework: components, activation trees, rates, checks, state machines, probes.
#![no_std]

pub mod check;
pub mod graph;
