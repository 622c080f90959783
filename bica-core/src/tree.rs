//! A tree of components: what `activation_tree!` generates, and what a program does with it.
//!
//! The modules below are one concept: the engine that runs cycles, and the state that it stores.

use embassy_time::Instant;

use crate::graph::{self, Graph};
use crate::hold::Hold;
use crate::id::ComponentId;
use crate::key::Key;
use crate::output::OutputSink;
use crate::params::{Setting, Value};
use crate::probe::Probe;
use crate::rate::Rate;
use crate::refusal::{Reason, Refusal};

mod activation;
pub(crate) mod component_state;
mod cycle;
pub(crate) mod cycle_state;
pub(crate) mod deferred;
mod engine;
pub(crate) mod going;
mod handle;
pub(crate) mod layout;
mod lone_machine;
pub(crate) mod member;
mod operate;
pub(crate) mod plan;
pub(crate) mod results;
pub(crate) mod steady;
pub(crate) mod tuning;
mod visit;
pub(crate) mod written;

pub use handle::Handle;
pub use layout::{Has, Layout, Member, MemberOf, ParamsOf, WorkOf};
pub use lone_machine::LoneMachine;

/// A tree of components, made by `activation_tree!`.
///
/// Between two ticks the owner writes what was sensed and reads what is to be done; [`tick`](Tree::tick) computes the one
/// from the other. A tree does no input or output and reads no clock: the same inputs at the same instants give the same
/// outputs, bit for bit.
///
/// # By type or by key
/// Functions with a type parameter serve code that knows the component. Those with a [`Key`] serve tools and tests:
/// the key is the component's name, or the identifier that [`Tree::id`] and [`Tree::find`] return. [`Tree::of`] and [`Tree::at`] give
/// a [`Handle`] of a component by its type or its key, with the same functions. Parameters, outputs and modulations have a [`Key`]: a
/// name, or an index.
///
/// # Panics in a step
/// If a step, a hook, a transition or a probe panics and the caller catches the unwinding, the tree stays usable:
///
/// - [`is_active`](Handle::is_active) and [`state`](Tree::state) show the tree as it was when the tick unwound.
/// - The next tick begins with stopping every component that was active then, activators first: their `#[stop]` hooks are
///   called. After that the tree starts as if they had never been active: every component that is visited is started, and a
///   state machine that was active begins in its initial state, also if it resumes.
///
/// So a component for which `start` was called is stopped once, and no component continues without `start`, whatever the
/// tick had done before. Values of components, parameters, rates and holds stay as they are. If a `#[stop]` hook panics, its component
/// counts as stopped. Ticks that do not unwind do not pay for this.
pub trait Tree: Layout {
    /// All that is known of the tree before it runs.
    const GRAPH: Graph;
    /// Hash of [`GRAPH`](Tree::GRAPH): see [`graph::hash`].
    ///
    /// Two programs whose trees have one hash mean the same by every index: of a component, a state, a parameter.
    const HASH: u64 = graph::hash(&Self::GRAPH);
    /// Number of components in the tree.
    const COUNT: usize = Self::GRAPH.nodes.len();

    /// Runs one cycle: visits the root, and through it the active components.
    ///
    /// A component visits its required children in the order of its signature, runs if it is due, and then visits its
    /// modulated children in the order of its signature. A clock that stands still or jumps is tolerated; see
    /// [`rate`](crate::rate).
    #[inline]
    fn tick(&mut self, now: Instant) {
        self.tick_with(now, &mut ());
    }

    /// Runs one cycle, watched by `probe`.
    #[inline]
    fn tick_with<P: Probe>(&mut self, now: Instant, probe: &mut P) {
        self.engine_mut().tick(now, probe);
    }

    /// Reads component `C`.
    fn get<C: 'static>(&self) -> &C
    where
        Self: Has<C>,
    {
        self.engine().store.get()
    }

    /// Writes component `C`.
    fn get_mut<C: 'static>(&mut self) -> &mut C
    where
        Self: Has<C>,
    {
        self.engine_mut().store.get_mut()
    }

    /// Reads the rate of component `C`.
    fn rate<C: 'static>(&self) -> &Rate<C>
    where
        Self: Has<C>,
    {
        self.engine().store.rate()
    }

    /// Writes the rate of component `C`.
    fn rate_mut<C: 'static>(&mut self) -> &mut Rate<C>
    where
        Self: Has<C>,
    {
        self.engine_mut().store.rate_mut()
    }

    /// Returns the identifier of component `C`, its index in the tree's list.
    #[must_use]
    fn id<C: 'static>() -> ComponentId
    where
        Self: Has<C>,
    {
        ComponentId::new(Self::INDEX)
    }

    /// Returns the identifier of the component with this key.
    ///
    /// # Errors
    /// If the tree has no such component.
    fn find(component: impl Key) -> Result<ComponentId, Refusal> {
        let reason = Reason::UnknownComponent { nodes: Self::GRAPH.nodes };
        Self::GRAPH.find(component).ok_or(Refusal { entry: 0, component: "", name: "", reason })
    }

    /// Returns component `C`, to read what the framework knows of it.
    fn of<C: 'static>(&self) -> Handle<&Self>
    where
        Self: Has<C>,
    {
        Handle::new(self, Self::id::<C>())
    }

    /// Returns component `C`, to hold it or set its rate, too.
    fn of_mut<C: 'static>(&mut self) -> Handle<&mut Self>
    where
        Self: Has<C>,
    {
        Handle::new(self, Self::id::<C>())
    }

    /// As [`of`](Tree::of), by key.
    ///
    /// # Errors
    /// If the tree has no such component.
    fn at(&self, component: impl Key) -> Result<Handle<&Self>, Refusal> {
        Self::find(component).map(|component| Handle::new(self, component))
    }

    /// As [`of_mut`](Tree::of_mut), by key.
    ///
    /// # Errors
    /// If the tree has no such component.
    fn at_mut(&mut self, component: impl Key) -> Result<Handle<&mut Self>, Refusal> {
        Self::find(component).map(|component| Handle::new(self, component))
    }

    /// Reads all parameters of component `C`: a [`Tuned<P>`](crate::Tuned), or pairs of these if its functions take several.
    fn params<C: 'static>(&self) -> &ParamsOf<Self, C>
    where
        Self: Has<C>,
    {
        self.engine().store.params()
    }

    /// Replaces all parameters of component `C`, from the next cycle on.
    ///
    /// # Errors
    /// If the tree is not tunable, a value is not finite or out of range, or a rule is broken; then nothing changes.
    fn set_params_of<C: 'static>(&mut self, values: ParamsOf<Self, C>) -> Result<(), Refusal>
    where
        Self: Has<C>,
    {
        tuning::set_all::<Self, C>(self, values)
    }

    /// Returns an entry of a batch: a value for a parameter.
    ///
    /// # Errors
    /// If the tree has no such component or parameter. Whether the value is valid is checked when the batch is applied.
    fn setting(component: impl Key, parameter: impl Key, value: Value) -> Result<Setting, Refusal> {
        let (component, index, _) = tuning::find::<Self>(component, parameter)?;
        Ok(Setting::new(component, index as u16, value))
    }

    /// Applies a batch of settings, from the next cycle on: all of them or, if one is refused, none.
    ///
    /// # Errors
    /// The first setting that is refused: the tree is not tunable, the parameter does not exist or is set twice, the value
    /// is of another kind, not finite or out of range; or the resulting values of a component break a rule.
    fn set_params(&mut self, batch: &[Setting]) -> Result<(), Refusal> {
        tuning::set(self, batch)
    }

    /// Passes an output of [`Node::outputs`](crate::graph::Node::outputs) to `sink`; returns whether it exists. The getter is
    /// called only now.
    fn read_output(&self, component: impl Key, output: impl Key, sink: &mut impl OutputSink) -> bool {
        operate::read(self, component, output, sink)
    }

    /// Calls a modulation of [`Node::modulations`](crate::graph::Node::modulations), as an activator would before the next
    /// cycle.
    ///
    /// # Errors
    /// If there is no such modulation, or an argument is missing, of another kind, not finite or out of range; then
    /// nothing is called. The entry of the refusal is the index of the argument.
    fn modulate(&mut self, component: impl Key, modulation: impl Key, arguments: &[Value]) -> Result<(), Refusal> {
        operate::modulate(self, component, modulation, arguments)
    }

    /// Returns the component and the index of a modulation.
    ///
    /// # Errors
    /// If the tree has no such component or modulation.
    fn find_modulation(component: impl Key, modulation: impl Key) -> Result<(ComponentId, usize), Refusal> {
        operate::find::<Self>(component, modulation)
    }

    /// Returns the components that were visited in the last cycle, in the order of the tree's list.
    fn active(&self) -> impl Iterator<Item = ComponentId> {
        (0..Self::COUNT).map(ComponentId::new).filter(|&component| self.engine().is_active(component))
    }

    /// Returns the state of a state machine, an index in [`Node::states`](crate::graph::Node::states); for a latent one
    /// the state in which it became latent.
    ///
    /// `None` for a component that has no states or was never active.
    fn state(&self, component: impl Key) -> Option<usize> {
        self.status(component)?.state
    }

    /// State of a component between two cycles; `None` for one that the tree does not list.
    fn status(&self, component: impl Key) -> Option<Status> {
        let component = Self::GRAPH.find(component)?;
        let state = Self::component_state(self.engine().store.slots(), component.index())?;
        Some(Status {
            active: self.engine().is_active(component),
            held: state.activation().held(),
            state: state.state(),
            since: state.since(),
            hz: Self::hz(self, component.index()),
        })
    }
}

/// State of a component between two cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Status {
    /// Whether it was visited in the last cycle.
    pub active: bool,
    /// How it is held.
    pub held: Hold,
    /// State of its state machine, also of a latent one: an index in [`Node::states`](crate::graph::Node::states).
    pub state: Option<usize>,
    /// Instant at which the state was entered; without states, at which the component became active. `None` if it was
    /// never active.
    pub since: Option<Instant>,
    /// Requested runs per second; `None` is a run in every cycle.
    pub hz: Option<f32>,
}
