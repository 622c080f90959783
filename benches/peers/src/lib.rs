//! The same workloads in BICA and in other designs, for a comparison of times.
//!
//! [`part`] defines the workloads. Each other module implements them in one design: [`framework`] with BICA, [`plain`]
//! as functions written by hand, [`boxed`] as `Box<dyn Component>`, [`callbacks`] and [`channels`] over a blackboard.
//! [`machine`] is a machine of five states by hand, with statig and with smlang; [`behavior_tree`] ten leaves of a behavior
//! tree by hand and with bonsai-bt. `copper` needs the feature of its name, because copper-rs takes minutes to compile.
//! [`cases`] lists what is measured; `benches/scripts/peers.py` measures it, prints tables, and checks the claims.
#![recursion_limit = "256"]

pub mod behavior_tree;
pub mod boxed;
pub mod callbacks;
pub mod case;
pub mod cases;
pub mod channels;
#[cfg(feature = "copper")]
pub mod copper;
pub mod framework;
pub mod machine;
pub mod part;
pub mod plain;
pub mod subject;
pub mod timer;
