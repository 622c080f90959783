//! The unit of behaviour.

use embassy_time::{Duration, Instant, TICK_HZ};

use crate::graph::{InForce, State, WorkFunction};
use crate::modulation::Modulation;
use crate::output::Output;
use crate::params::{ParamGroup, Value};
use crate::role::RoleName;
use crate::work::WorkSlot;

/// The unit of behaviour: it perceives, acts, or decides between the two.
///
/// `#[component]` on a type's impl block implements this. A program reads the constants; it never implements the trait by
/// hand.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no component",
    label = "its impl block has no `#[component]`",
    note = "write `#[component]` on the impl block that holds its `step` or its states"
)]
pub trait Component: Sized + 'static {
    /// The type itself: a tree that names it finds out whether it is a component.
    #[doc(hidden)]
    type Itself;
    /// The impl block that makes the component. Only this trait collides if there are two, so there is one message.
    #[doc(hidden)]
    type Block;
    /// The type's name, without its path.
    const NAME: &'static str;
    /// The doc comment of the impl block, or else of the type with `#[derive(ComponentDoc)]`, or else of the step.
    const DOC: &'static str;
    /// Declared rate, runs per second; `None` is a run in every cycle.
    const HZ: Option<f32>;
    /// Declared longest time of one run, µs.
    const BUDGET_US: Option<f32>;
    /// Whether a state machine continues in the state in which it became latent.
    const RESUME: bool;
    /// Which of several components counts that write this one in one cycle; `None` if it does not say so.
    const WRITERS: Option<InForce> = None;
    /// The states, in the order of the text; empty for a component that is no state machine.
    const STATES: &'static [State];
    /// All parameters, which the functions take as `&Tuned<P>`: `()`, a [`Tuned`](crate::Tuned), or pairs of these.
    type Params: 'static;
    /// Description of the parameters, one group for each struct.
    const PARAMS: &'static [ParamGroup] = &[];
    /// The outputs: getters with `#[output]`.
    const OUTPUTS: &'static [Output] = &[];
    /// The modulations that an operator may call: methods with `#[modulation]`.
    const MODULATIONS: &'static [Modulation] = &[];
    /// The function that runs beside the loop.
    const WORK: Option<&'static WorkFunction> = None;
    /// The roles for which its arguments ask.
    #[doc(hidden)]
    const ROLES: &'static [RoleName] = &[];
    /// The place of its jobs; `()` without one.
    #[doc(hidden)]
    type Work: WorkSlot;
    /// The default values of the parameters.
    const DEFAULT_PARAMS: Self::Params;
    /// The same as a reference, which an untunable tree returns.
    #[doc(hidden)]
    const CONSTANT_PARAMS: &'static Self::Params;
    /// Index in [`STATES`](Self::STATES) of the state in which the machine starts.
    #[doc(hidden)]
    const INITIAL: usize = 0;
    /// Whether the component stands in for one with mistakes, which are reported already.
    #[doc(hidden)]
    const IS_STUB: bool = false;

    /// Reads a parameter by its index, counted through the groups.
    #[doc(hidden)]
    fn param(_params: &Self::Params, _index: usize) -> Option<Value> {
        None
    }

    /// Writes a parameter; does nothing if the value is of another kind or the index too large.
    #[doc(hidden)]
    fn put_param(_params: &mut Self::Params, _index: usize, _value: Value) {}

    /// Checks the rules of all structs of parameters.
    #[doc(hidden)]
    fn check_params(_params: &Self::Params) -> Result<(), &'static str> {
        Ok(())
    }
}

/// The times of a component in this run: an argument `time: &Time` takes them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Time {
    /// Instant of this cycle, as given to the tick.
    pub now: Instant,
    /// Time since the previous run, exact to a clock tick; zero in the first run after the component became active.
    pub since_run: Duration,
    /// Time since the state machine entered its state, exact to a clock tick; without states, since the component became
    /// active.
    pub in_state: Duration,
}

impl Time {
    /// Returns [`since_run`](Self::since_run) in seconds, for control laws.
    ///
    /// The relative resolution is 2⁻²⁴: 10 ns for 0.1 s, 8 ms for a day.
    #[must_use]
    pub fn dt(&self) -> f32 {
        self.since_run.as_ticks() as f32 / TICK_HZ as f32
    }

    /// Returns [`in_state`](Self::in_state) in seconds.
    ///
    /// It is an `f64` because a state may last: the resolution is 1 µs up to 272 years, where an `f32` resolves only 8 ms
    /// after a day. A processor without double precision compares `in_state` with a [`Duration`] faster.
    #[must_use]
    pub fn in_state_s(&self) -> f64 {
        self.in_state.as_ticks() as f64 / TICK_HZ as f64
    }
}
