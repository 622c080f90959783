//! The framework: components, activation trees, rates, checks, state machines, probes.
//!
//! Most programs use it through the facade `bica`. A program that does not tells the macros where they are:
//!
//! ```
//! use bica_core::{Instant, Tree};
//! use bica_macros::{activation_tree, component};
//!
//! pub struct Blink { on: bool }
//!
//! #[component(hz = 2, crate = bica_core)]
//! impl Blink {
//!     pub const fn new() -> Self { Self { on: false } }
//!
//!     fn step(&mut self) { self.on = !self.on; }
//! }
//!
//! activation_tree! {
//!     pub struct Light { root: Blink, cycle_hz: 100, components: [Blink], crate: bica_core }
//! }
//!
//! let mut light = Light::new();
//! light.tick(Instant::from_millis(0));
//! light.tick(Instant::from_millis(10));
//! assert!(light.get::<Blink>().on);
//! ```
//!
//! # How components run
//!
//! 1. A component is visited at most once in a cycle, however many activate it.
//! 2. A visit first visits the required children, then, if it is due, runs the component, then visits the modulated
//!    children. A component that is not due passes the visit on all the same, so a child may run faster.
//! 3. It is due at its rate, on a fixed grid that begins with its first run, and in every cycle without a rate. Late by
//!    less than a period keeps the grid; later than that it runs once, at once, and the grid begins anew: never a burst,
//!    never a run that is lost. A clock that is set back by more than a period also begins a new grid.
//! 4. The [`Rate`] can be modulated by a parent and from outside, up to the declared one.
//! 5. Active is what was visited in this cycle. What becomes active is started and due at once; what is active no more is
//!    stopped at the end of the cycle, an activator before what it activated. What is latent costs nothing.
//! 6. A state machine that was latent begins in its initial state, unless it is told to resume.
//! 7. A machine tries its transitions before the function of its state, and takes at most one in a run; the new state's
//!    required children are visited and its function runs in the same run. Timers go by the instant that the tree is
//!    given; one that finds the clock set back to before the state was entered counts from there.
//! 8. Any component can be held active or latent from outside: [`Hold`].
//! 9. Overload, a clock that stands still or jumps, and rates that are no number never panic.
#![no_std]

pub mod check;
pub mod component;
pub mod graph;
pub mod hold;
pub mod id;
pub mod probe;
pub mod rate;
pub mod render;
pub mod stopwatch;
pub mod tree;

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
pub use stopwatch::Stopwatch;
pub use tree::{Has, Status, Tree};
