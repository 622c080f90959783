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
//! 1. A component is visited at most once in a cycle, however many components link to it.
//! 2. A visit first visits the required children, then runs the component if it is due, and then visits the modulated
//!    children. A component that is not due passes the visit on all the same, so a child may run faster.
//! 3. Siblings are visited in the order of the text: the required children in the order in which the signature names
//!    them, and so the modulated ones. In a state the links of its function come first, then those of its entry hooks, its
//!    exit hooks, its `#[before]`, and the transitions that leave it, each in the order of the text.
//! 4. A component is due at its rate, on a fixed grid that begins with its first run, and in every cycle without a rate.
//!    [`rate`] states exactly how early and late ticks are treated: no run is lost or added by jitter below half a cycle,
//!    and a run that is later than a period starts the grid anew, never a burst.
//! 5. A parent, and the owner of the tree, can set the [`Rate`] up to the declared one.
//! 6. A component is active if it was visited in this cycle. One that becomes active is started and due at once; one that is
//!    not visited any more is stopped at the end of the cycle, an activator before what it activated. A latent component
//!    costs nothing.
//! 7. A state machine that was latent begins in its initial state, unless it has the option `resume`.
//! 8. A state machine evaluates its transitions before the function of its state, and takes at most one in a run. In a run that
//!    begins in a state, the state's `#[before]` runs before that; what a transition found goes to the entry hook. The
//!    required children of the new state are visited and its function runs in the same run. Timers compare the instants that
//!    the tree is given, exact to a clock tick. If the clock was set back to before the state was entered, the time in the
//!    state counts from there.
//! 9. Any component can be held active or latent from outside: [`Hold`].
//! 10. Overload, a clock that stands still or jumps, and rates that are no number never panic.
//! 11. After a tick that unwound, the next one stops everything that was active and starts anew: see [`Tree`].
//!
//! # Limits
//!
//! A tree has at most 255 components, a state machine at most 255 states ([`check::CAPACITY`]). The compiler reports what
//! exceeds them.
#![no_std]

pub mod action;
mod age;
pub mod blob;
pub mod check;
mod component;
mod found;
pub mod graph;
mod hold;
mod id;
mod key;
mod marked;
pub mod modulation;
mod outcome;
pub mod output;
pub mod params;
mod place;
pub mod probe;
pub mod rate;
pub mod render;
#[doc(hidden)]
pub mod role;
pub mod stopwatch;
mod text;
mod tree;
pub mod visual;
pub mod work;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;

pub use age::Age;
pub use blob::{Blob, Format};
pub use component::{Component, Time};
pub use embassy_time::{Duration, Instant};
pub use found::Found;
pub use graph::{End, Graph};
pub use hold::Hold;
pub use id::ComponentId;
pub use key::Key;
pub use outcome::Outcome;
pub use params::refusal::{self, Refusal};
pub use params::{ParamEnum, Params, Setting, Tuned, Value};
pub use place::{Axis, Hint, Place};
pub use probe::Probe;
pub use rate::Rate;
pub use role::{Fills, Role};
pub use stopwatch::Stopwatch;
pub use tree::{Handle, Has, LoneMachine, ParamsOf, Status, Tree};
pub use work::{JobEnd, Work};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
