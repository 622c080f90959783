#![cfg_attr(feature = "dds", doc = include_str!("../README.md"))]
#![cfg_attr(not(feature = "dds"), doc = "ROS 2 nodes: all of this crate needs its feature `dds`.")]
#![cfg(feature = "dds")]

mod message;
mod node;

pub use bica_recording::ros::checked_namespace;
pub use node::{Options, Ros, bridge};
