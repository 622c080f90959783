#![doc = include_str!("../README.md")]

mod app;
mod bench;
mod console;
mod graph;
mod link;
mod log;
#[cfg(feature = "monitor")]
mod monitor;
mod names;
mod params;
mod record;
mod replay;
#[cfg(feature = "ros")]
mod ros;
mod run;
mod start;
mod tool;
mod values;
mod world;

pub use app::App;
#[cfg(feature = "monitor")]
pub use bica_monitor;
pub use clap;
pub use console::*;
pub use link::{RosNode, ServeArgs};
pub use params::{InForce, Layer, TuningArgs, in_force, print_in_force};
pub use record::{Images, RecordArgs, RecordedFile, TopicsArg};
#[cfg(feature = "ros")]
pub use ros::NodeArgs;
pub use run::RunArgs;
pub use values::seconds;
pub use world::WorldOptions;
