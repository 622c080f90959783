//! The same workloads in BICA and in other designs, for a comparison of times.
//!
//! [`part`] defines the workloads. Each other module implements them in one design: [`framework`] with BICA, [`plain`]
//! as functions written by hand, [`boxed`] as `Box<dyn Component>`, [`callbacks`] and [`channels`] over a blackboard.
//! [`machine`] is a machine of five states by hand, with statig and with smlang. copper-rs is in a crate of its own,
//! because it takes minutes to compile. [`report`] prints the measurements and checks the claims.
#![recursion_limit = "256"]

pub mod boxed;
pub mod callbacks;
pub mod channels;
pub mod framework;
pub mod machine;
pub mod part;
pub mod plain;
pub mod report;
pub mod subject;
pub mod timer;
