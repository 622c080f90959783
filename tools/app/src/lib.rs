//! The whole program of a robot, from its tree and its worlds.
//!
//! ```no_run
//! use std::process::ExitCode;
//!
//! use bica_app::App;
//! # use std::convert::Infallible;
//! # use bica::prelude::*;
//! # use bica::runner::{Robot, World};
//! # pub struct Wheels { speed: f32 }
//! # #[component]
//! # impl Wheels { pub const fn new() -> Self { Self { speed: 0.1 } } }
//! # activation_tree! { pub struct Cart { root: Wheels, cycle_hz: 50, components: [Wheels] } }
//! # impl Robot for Cart {
//! #     type Sensors<'a> = f32;
//! #     type Command = f32;
//! #     type Error = Infallible;
//! #     fn sense(&mut self, _: &f32) -> Result<(), Infallible> { Ok(()) }
//! #     fn act(&mut self) -> f32 { self.get::<Wheels>().speed }
//! # }
//! # struct Room { seed: u64, distance: f32 }
//! # impl Room { fn new(seed: u64) -> Self { Self { seed, distance: 2.0 } } }
//! # impl World<Cart> for Room {
//! #     fn now(&self) -> Instant { Instant::from_millis(self.seed) }
//! #     fn sensors(&mut self) -> f32 { self.distance }
//! #     fn act(&mut self, speed: &f32) { self.distance -= speed * 0.02; }
//! # }
//!
//! fn main() -> ExitCode {
//!     App::<Cart>::new("cart").world("room", |options| Room::new(options.seed)).run()
//! }
//! ```
//!
//! The program has these commands:
//!
//! | command | effect |
//! |---|---|
//! | `cart run` | runs the robot in a world: as fast as possible or in real time, with parameters, served to monitors |
//! | `cart graph` | prints the activation tree as a drawing, for Graphviz or Mermaid, or as JSON |
//! | `cart params` | lists the parameters and writes tune files |
//! | `cart run --record FILE` | records the run |
//! | `cart replay` | runs the code again on a recording and compares, bit for bit |
//! | `cart record` | prints what a recording contains; mends and cuts it |
//! | `cart monitor` | with the feature `monitor`: serves a web page that shows, tunes, drives and records the robot |
//! | `cart link` | attaches to a running robot: watches it, sets parameters, holds components, calls modulations |
//!
//! A program adds commands of its own with [`App::commands`].

mod app;
mod console;
mod graph;
mod link;
#[cfg(feature = "monitor")]
mod monitor;
mod params;
mod record;
mod replay;
mod run;
mod start;
mod tool;
mod world;

pub use app::App;
pub use clap;
pub use console::*;
pub use link::ServeArgs;
pub use params::{Layer, TuningArgs};
pub use record::{Images, RecordArgs, RecordedFile, TopicsArg};
pub use run::seconds;
pub use world::WorldOptions;
