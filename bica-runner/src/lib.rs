//! The sense-think-act loop around an activation tree.
//!
//! A robot program has three parts. The [`Robot`] is the tree with the code that writes sensor values into it and reads
//! the command out of it. The [`World`] is what the program controls: a real body, a simulation, or recorded sensor
//! values. The [`Runner`] connects the two. One [`cycle`](Runner::cycle) is:
//!
//! 1. apply the [requests](Requests) of operators and tools,
//! 2. write the sensor values into the tree ([`Robot::sense`]),
//! 3. tick the tree,
//! 4. read the command ([`Robot::act`]) and pass it to the world,
//!
//! An [`Observer`] receives each of these steps.
//!
//! ```
//! use bica_core::{Instant, Tree};
//! use bica_macros::{activation_tree, component};
//! use bica_runner::{Robot, Runner, World};
//!
//! /// Distance to the obstacle ahead, m.
//! pub struct Sonar { distance: f32 }
//!
//! #[component(crate = bica_core)]
//! impl Sonar {
//!     pub const fn new() -> Self { Self { distance: 0.0 } }
//! }
//!
//! pub struct Drive { speed: f32 }
//!
//! #[component(crate = bica_core)]
//! impl Drive {
//!     pub const fn new() -> Self { Self { speed: 0.0 } }
//!
//!     /// Drives ahead and stops before the obstacle.
//!     fn step(&mut self, sonar: &Sonar) { self.speed = (sonar.distance - 0.2).clamp(0.0, 0.5); }
//! }
//!
//! activation_tree! {
//!     pub struct Cart { root: Drive, cycle_hz: 50, components: [Drive, Sonar], crate: bica_core }
//! }
//!
//! impl Robot for Cart {
//!     type Sensors<'a> = f32;
//!     type Command = f32;
//!     type Error = core::convert::Infallible;
//!
//!     fn sense(&mut self, distance: &f32) -> Result<(), Self::Error> {
//!         self.get_mut::<Sonar>().distance = *distance;
//!         Ok(())
//!     }
//!
//!     fn act(&mut self) -> f32 { self.get::<Drive>().speed }
//! }
//!
//! /// A straight road with a wall at its end.
//! struct Road { cycle: u64, distance: f32 }
//!
//! impl World<Cart> for Road {
//!     fn now(&self) -> Instant { Instant::from_millis(20 * self.cycle) }
//!     fn sensors(&mut self) -> f32 { self.distance }
//!     fn act(&mut self, speed: &f32) {
//!         self.distance -= speed * 0.02;
//!         self.cycle += 1;
//!     }
//! }
//!
//! let mut cart = Cart::new();
//! let mut runner = Runner::new(&mut cart, Road { cycle: 0, distance: 2.0 });
//! for _ in 0..1000 {
//!     runner.cycle()?;
//! }
//! assert!((runner.world().distance - 0.2).abs() < 0.01);
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! # Which loop
//!
//! | the world | the loop |
//! |---|---|
//! | a simulation at maximum speed | [`Runner::cycle`] in a `while` |
//! | a real robot with an operating system, or a simulation in real time | `Runner::run` (feature `std`) |
//! | a microcontroller with embassy | `Runner::run_async` (feature `embassy`) |
//! | sensor values received as messages | [`Runner::sense`] and [`Runner::think`] |
//! | a test | the module `harness` (feature `std`) |
//!
//! # Who runs jobs
//!
//! Components may have [work beside the loop](bica_core::work). [`Runner::with_jobs`] says who runs their jobs:
//!
//! | jobs | run |
//! |---|---|
//! | `()` | by the cycle in which they are due: simulated time |
//! | `workers::Workers` (feature `std`) | by threads, in simulated or in real time |
//! | [`IdleTime`] | in slices between the cycles of a microcontroller |
//! | `workers::HeldJobs` (feature `std`) | in the cycles in which a recorded run had their results |
//!
//! Without features the crate needs neither an operating system nor a heap. All types are static: a runner without
//! requests and observer compiles to the three calls `sense`, `tick` and `act`.
#![no_std]

#[cfg(feature = "std")]
extern crate std;

mod clock;
mod jobs;
mod observer;
#[cfg(feature = "std")]
mod queue;
mod request;
mod robot;
mod runner;
pub mod schedule;
mod timing;
mod world;

#[cfg(feature = "embassy")]
mod embassy;
#[cfg(feature = "std")]
pub mod harness;
#[cfg(feature = "std")]
pub mod realtime;
#[cfg(feature = "std")]
pub mod workers;

pub use clock::ClockStep;
pub use jobs::{IdleTime, Jobs};
pub use observer::{Cycle, Observer};
#[cfg(feature = "std")]
pub use queue::{OwnedRequest, RequestQueue};
pub use request::{Change, Request, Requests};
pub use robot::Robot;
#[cfg(feature = "std")]
pub use robot::STACK_BYTES;
pub use runner::Runner;
pub use schedule::{Overrun, OverrunPolicy, RunError, Schedule};
pub use timing::Timing;
pub use world::World;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
