//! The unit of behaviour.

use embassy_time::{Duration, Instant};

use crate::graph::State;

/// The unit of behaviour: it perceives, acts, or decides between the two.
///
/// `#[component]` on a type's impl block writes this. A program reads the constants; it never implements the trait by
/// hand.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no component",
    label = "its impl block bears no `#[component]`",
    note = "write `#[component]` on the impl block that holds its `step` or its states"
)]
pub trait Component: Sized + 'static {
    /// The type's name, without its path.
    const NAME: &'static str;
    /// The doc comment of the impl block, or else of the step.
    const DOC: &'static str;
    /// Declared rate, runs per second; `None` runs in every cycle.
    const HZ: Option<f32>;
    /// Declared time of one run, µs.
    const BUDGET_US: Option<f32>;
    /// Whether a state machine goes on in the state that it was in when it became latent.
    const RESUME: bool;
    /// The states, in the order of the text; empty for a component that is no state machine.
    const STATES: &'static [State];
    /// Index in [`STATES`](Self::STATES) of the state in which the machine starts.
    #[doc(hidden)]
    const INITIAL: usize = 0;
    /// Whether the component stands in for one with mistakes, which are reported already.
    #[doc(hidden)]
    const IS_STUB: bool = false;
}

/// What a component may know of time: ask for it with an argument `time: &Time`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Time {
    /// The instant that this cycle was given.
    pub now: Instant,
    /// Since the run before; zero in the first run after the component became active.
    pub since_run: Duration,
    /// Since the machine entered its state; without states, since the component became active.
    pub in_state: Duration,
}

impl Time {
    /// Seconds since the run before; zero in the first run after the component became active.
    #[must_use]
    pub fn dt(&self) -> f32 {
        seconds(self.since_run)
    }

    /// Seconds in the state; without states, since the component became active.
    #[must_use]
    pub fn in_state_s(&self) -> f32 {
        seconds(self.in_state)
    }
}

fn seconds(span: Duration) -> f32 {
    span.as_ticks() as f32 / embassy_time::TICK_HZ as f32
}
