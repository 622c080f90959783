//! Requests of operators and tools to a running robot.

use bica_core::action::{self, Actions};
use bica_core::graph::Graph;
use bica_core::params::{Setting, Value};
use bica_core::refusal::{Reason, Refusal};
use bica_core::{ComponentId, Hold, Instant, Key, Tree};

/// Change of the tree or of its world from outside, applied between two cycles. `S` contains settings, and `V` values: borrowed in the loop
/// ([`Request`]), on the heap in a tool (`OwnedRequest`), of bounded size in a message.
///
/// All changes except the sensor values are requests, so a recording of requests and sensor values is complete.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
pub enum Change<S, V> {
    /// Holds a component active or latent, or releases it.
    Hold {
        /// Component.
        component: ComponentId,
        /// Hold from the next tick on.
        hold: Hold,
    },
    /// Changes the rate of a component.
    Rate {
        /// Component.
        component: ComponentId,
        /// Runs per second: above 0, and at most the declared rate or, without one, the rate of the cycles. `None` is the declared rate.
        hz: Option<f32>,
    },
    /// Sets parameters, of any number of components: all of them or, if one is refused, none.
    Params(S),
    /// Calls a modulation of a component.
    Modulate {
        /// Component.
        component: ComponentId,
        /// Index in [`Node::modulations`](bica_core::graph::Node::modulations).
        modulation: u16,
        /// One value for each argument.
        arguments: V,
    },
    /// Performs an action of the world.
    World {
        /// Index in the list of the world's [`actions`](crate::World::actions).
        action: u16,
        /// One value for each argument.
        arguments: V,
    },
    /// Makes a state machine go to a state in the next cycle.
    Go {
        /// Component.
        component: ComponentId,
        /// Index in [`Node::states`](bica_core::graph::Node::states).
        state: u16,
    },
}

impl<S, V> Change<S, V> {
    /// Whether it calls a stop of the tree with this graph.
    #[must_use]
    pub fn is_stop(&self, graph: &Graph) -> bool {
        matches!(*self, Self::Modulate { component, modulation, .. } if graph.is_stop(component, modulation.into()))
    }
}

/// A change with borrowed values.
pub type Request<'a> = Change<&'a [Setting], &'a [Value]>;

impl<S: AsRef<[Setting]>, V: AsRef<[Value]>> Change<S, V> {
    /// Returns the change with borrowed values.
    #[must_use]
    pub fn borrow(&self) -> Request<'_> {
        match self {
            &Self::Hold { component, hold } => Change::Hold { component, hold },
            &Self::Rate { component, hz } => Change::Rate { component, hz },
            Self::Params(settings) => Change::Params(settings.as_ref()),
            &Self::Modulate { component, modulation, ref arguments } => {
                Change::Modulate { component, modulation, arguments: arguments.as_ref() }
            }
            &Self::World { action, ref arguments } => Change::World { action, arguments: arguments.as_ref() },
            &Self::Go { component, state } => Change::Go { component, state },
        }
    }
}

impl<'a> Request<'a> {
    /// Returns the change with its values in containers of another type; `None` if one is too small.
    #[must_use]
    pub fn store<S: TryFrom<&'a [Setting]>, V: TryFrom<&'a [Value]>>(self) -> Option<Change<S, V>> {
        Some(match self {
            Self::Hold { component, hold } => Change::Hold { component, hold },
            Self::Rate { component, hz } => Change::Rate { component, hz },
            Self::Params(settings) => Change::Params(settings.try_into().ok()?),
            Self::Modulate { component, modulation, arguments } => {
                Change::Modulate { component, modulation, arguments: arguments.try_into().ok()? }
            }
            Self::World { action, arguments } => Change::World { action, arguments: arguments.try_into().ok()? },
            Self::Go { component, state } => Change::Go { component, state },
        })
    }

    /// Requests a call of a modulation of tree `T` by names.
    ///
    /// # Errors
    /// If the tree has no such component or modulation. Whether the arguments are valid is checked when the request is applied.
    pub fn modulate<T: Tree>(
        component: impl Key,
        modulation: impl Key,
        arguments: &'a [Value],
    ) -> Result<Self, Refusal> {
        let (component, index) = T::find_modulation(component, modulation)?;
        Ok(Self::Modulate { component, modulation: index as u16, arguments })
    }

    /// Applies the request to a tree without a world.
    ///
    /// # Errors
    /// As [`apply_in`](Self::apply_in).
    pub fn apply<T: Tree>(self, tree: &mut T) -> Result<(), Refusal> {
        self.apply_in(tree, None)
    }

    /// Applies the request to a tree, or to its world.
    ///
    /// # Errors
    /// If the tree has no such component, parameter, modulation or state, the world no such action, or a value, a rate or a way to a state
    /// is not accepted; then nothing changes.
    pub fn apply_in<T: Tree>(self, tree: &mut T, world: Option<&mut dyn Actions>) -> Result<(), Refusal> {
        match self {
            Self::Hold { component, hold } => tree.at_mut(component).map(|mut component| component.hold(hold)),
            Self::Rate { component, hz } => {
                possible::<T>(component, hz)?;
                tree.at_mut(component).map(|mut component| component.set_rate(hz))
            }
            Self::Params(batch) => tree.set_params(batch),
            Self::Modulate { component, modulation, arguments } => {
                tree.modulate(component, usize::from(modulation), arguments)
            }
            Self::World { action, arguments } => action::perform(world, usize::from(action), arguments),
            Self::Go { component, state } => tree.at_mut(component)?.go(usize::from(state)),
        }
    }
}

/// Checks a rate.
fn possible<T: Tree>(component: ComponentId, hz: Option<f32>) -> Result<(), Refusal> {
    let node = &T::GRAPH.nodes[T::find(component)?.index()];
    if hz.is_none_or(|hz| hz > 0.0 && hz <= node.hz.unwrap_or(T::GRAPH.cycle_hz)) {
        return Ok(());
    }
    let reason = Reason::Rule("a rate is above 0 Hz and at most the declared rate, or that of the cycles");
    Err(Refusal { entry: 0, component: node.name, name: "rate", reason })
}

/// Source of requests: a link to an operator, a script, a recording.
pub trait Requests {
    /// Returns the next request to apply before the cycle at `now`; `None` if there is no further one for this cycle.
    ///
    /// The runner applies requests until it receives `None`, so a source limits their number in a cycle.
    fn next(&mut self, now: Instant) -> Option<Request<'_>>;

    /// Receives the result of the request that the last [`next`](Self::next) returned.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    #[inline]
    fn answered(&mut self, now: Instant, result: Result<(), Refusal>) {}
}

/// Provides no requests.
impl Requests for () {
    #[inline]
    fn next(&mut self, _now: Instant) -> Option<Request<'_>> {
        None
    }
}

/// Provides the requests of a source, if there is one.
impl<Q: Requests> Requests for Option<Q> {
    #[inline]
    fn next(&mut self, now: Instant) -> Option<Request<'_>> {
        self.as_mut()?.next(now)
    }

    #[inline]
    fn answered(&mut self, now: Instant, result: Result<(), Refusal>) {
        if let Some(source) = self {
            source.answered(now, result);
        }
    }
}

impl<Q: Requests + ?Sized> Requests for &mut Q {
    #[inline]
    fn next(&mut self, now: Instant) -> Option<Request<'_>> {
        (**self).next(now)
    }

    #[inline]
    fn answered(&mut self, now: Instant, result: Result<(), Refusal>) {
        (**self).answered(now, result);
    }
}
