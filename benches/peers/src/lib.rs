//! The same work in BICA and in what else one could take, to be timed beside each other.
//!
//! [`part`] says what the work is. Each other module does it one way: [`ours`] with the framework, [`plain`] as functions
//! written by hand, [`boxed`] as `Box<dyn Component>`, [`callbacks`] and [`channels`] over a blackboard; [`machine`]
//! is a machine of five states by hand, with statig and with smlang. Copper lives in a crate of its own, for it is
//! heavy. [`report`] makes a table of what was measured and judges it.
#![recursion_limit = "256"]

pub mod boxed;
pub mod callbacks;
pub mod channels;
pub mod machine;
pub mod ours;
pub mod part;
pub mod plain;
pub mod report;
pub mod subject;
pub mod timer;
