//! Behaviour components for robots, with an activation graph that the compiler checks.
//!
//! A **component** is the unit of behaviour: it perceives, acts, or decides between the two. It is stepped iteratively, at
//! its own rate. It activates the components that it needs by naming them in the signature of its step. The
//! others are latent and cost nothing. The components that are active now are the **activation tree**: it has one root, and it
//! changes all the time.
//!
//! ```
//! use bica::prelude::*;
//!
//! pub struct Ball { offset: f32 }
//!
//! #[component]
//! impl Ball {
//!     pub const fn new() -> Self { Self { offset: 0.0 } }
//! }
//!
//! pub struct Head { pan: f32 }
//!
//! #[component]
//! impl Head {
//!     pub const fn new() -> Self { Self { pan: 0.0 } }
//! }
//!
//! pub struct FaceBall { gain: f32 }
//!
//! #[component(hz = 30, budget_us = 40)]
//! impl FaceBall {
//!     pub const fn new() -> Self { Self { gain: 0.5 } }
//!
//!     /// Keeps the ball in the middle of the image: `Ball` runs before, `Head` after.
//!     fn step(&mut self, ball: &Ball, head: &mut Head) {
//!         head.pan += self.gain * ball.offset;
//!     }
//! }
//!
//! activation_tree! {
//!     pub struct Robot { root: FaceBall, cycle_hz: 100, budget_ms: 5, components: [FaceBall, Ball, Head] }
//! }
//!
//! let mut robot = Robot::new();                  // no heap: it may stand in a `static`
//! robot.get_mut::<Ball>().offset = 0.8;          // sense
//! robot.tick(Instant::from_millis(0));           // think: one chain of direct calls
//! assert_eq!(robot.get::<Head>().pan, 0.4);      // act
//! ```
//!
//! # Overview
//!
//! - [`component`](macro@component): links, rates, budgets, state machines.
//! - [`role`](macro@role): what a component needs of another one, without naming it.
//! - [`activation_tree!`]: a robot's components, and what the compiler checks of them.
//! - [`Tree`]: ticking, reading and writing components, their rates, holding them active or latent.
//! - [`Probe`]: observing a tree; [`Stopwatch`]: how long each component takes.
//! - [`Graph`]: a tree's static description, for drawings and tools.
//! - [`Params`](derive@Params): values that are adjusted while the robot runs.
//! - [The crate underneath](bica_core): the rules by which components run.
//! - The examples of this package: `first_component`, `shared_child`, `state_machine`, `roles`, `plan_path`, `probe`,
//!   `parameters`, `static_tree`.
//!
//! This crate needs no operating system, no heap and no `unsafe` of its users.
#![no_std]

#[doc(hidden)]
pub use bica_core::__private;
pub use bica_core::{
    Age, Axis, Blob, Component, ComponentId, Duration, End, Fills, Format, Found, Graph, Handle, Has, Hint, Hold,
    Instant, JobEnd, Key, Outcome, ParamEnum, Params, ParamsOf, Place, Probe, Rate, Refusal, Setting, Status,
    Stopwatch, Time, Tree, Tuned, Value, Work, action, graph, modulation, output, params, probe, rate, refusal,
    stopwatch, visual, work,
};
#[doc(hidden)]
pub use bica_core::{check, render};
pub use bica_macros::{
    ComponentDoc, ParamEnum, Params, activation_tree, component, data, message, output, role, world_actions,
};
#[doc(inline)]
pub use bica_runner as runner;

/// What files of components, and the program around a tree, use.
pub mod prelude {
    pub use bica_core::action::Actions;
    pub use bica_core::{
        Age, Blob, Component, ComponentId, Duration, Format, Found, Has, Hold, Instant, Outcome, ParamEnum, Params,
        Probe, Rate, Refusal, Time, Tree, Tuned, Value, Work,
    };
    pub use bica_macros::{
        ComponentDoc, ParamEnum, Params, activation_tree, component, data, message, output, role, world_actions,
    };
    pub use bica_runner::{Robot, Runner, World};
    pub use core::convert::Infallible;
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
