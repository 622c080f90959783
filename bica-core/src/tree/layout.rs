//! What the macros implement for a tree and its components, and the types of these functions.

use core::cell::UnsafeCell;
use core::marker::PhantomData;
use core::mem::ManuallyDrop;

use super::component_state::ComponentState;
use super::cycle_state::{CycleState, VisitOutcome};
use super::plan::Plans;
use super::written::WrittenLink;
use crate::component::Component;
use crate::graph::Node;
use crate::output::OutputSink;
use crate::params::Value;
use crate::probe::Probe;
use crate::rate::Rate;

pub(crate) mod borrow;

/// Tree `Self` holds component `C`.
#[diagnostic::on_unimplemented(
    message = "activation tree `{Self}` does not hold component `{C}`",
    label = "`{C}` is not in the list",
    note = "if `{C}` is a component, add it to `components: [...]` of `{Self}`",
    note = "if it is a struct with `#[derive(Params)]`, the argument is `&Tuned<{C}>`",
    note = "if it is `Time`, `Rate` or `Tuned` by another name, write that name: `#[component]` reads names",
    note = "if it is a tree, take its components instead, each by an argument"
)]
pub trait Has<C: 'static>: Layout {
    /// `C`, known to be a component whose children the tree holds. It is the one place that requires this.
    #[doc(hidden)]
    type Member: MemberOf<Self>;

    /// What the slot stores of the component's parameters: all of them, or `()`.
    #[doc(hidden)]
    type Stored: 'static;

    /// Index of the component in the tree's list.
    const INDEX: usize;

    #[doc(hidden)]
    fn slot(slots: &Self::Slots) -> &Slot<C, Self::Stored, WorkOf<Self, C>>;
    /// The parameters; a tree that is not tunable has constants.
    #[doc(hidden)]
    #[inline]
    fn params(slots: &Self::Slots) -> &ParamsOf<Self, C> {
        let _ = slots;
        <Self::Member as Component>::CONSTANT_PARAMS
    }
    /// The parameters of a tunable tree.
    #[doc(hidden)]
    fn params_mut(slots: &mut Self::Slots) -> Option<&mut ParamsOf<Self, C>> {
        let _ = slots;
        None
    }

    /// Visits the component unless it was visited in this cycle or is held latent.
    #[doc(hidden)]
    fn visit<P: Probe>(cycle: &mut Cycle<'_, Self, P>);
    /// As `visit_once`, as a function of its own: several components link to this one.
    #[doc(hidden)]
    fn visit_shared<P: Probe>(cycle: &mut Cycle<'_, Self, P>);
    /// Visits a component that was not visited in this cycle.
    #[doc(hidden)]
    fn visit_once<P: Probe>(cycle: &mut Cycle<'_, Self, P>);
    /// Visits the component in a steady tick with this plan.
    #[doc(hidden)]
    #[inline]
    fn visit_steady<P: Probe, const PLAN: usize>(cycle: &mut Cycle<'_, Self, P>) {
        <Self as Has<C>>::visit(cycle);
    }
    /// Begins a visit in all cases. If the component goes to a state by request, its visit ends here.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn visit_otherwise<P: Probe>(_: &mut Cycle<'_, Self, P>) -> VisitOutcome {
        VisitOutcome::CLOSED
    }
    /// Begins the visit of a component without a declared rate that was latent or was given a rate. If it is not due,
    /// its visit ends here.
    #[doc(hidden)]
    #[must_use]
    fn visit_unusual<P: Probe>(_: &mut Cycle<'_, Self, P>) -> VisitOutcome {
        VisitOutcome::CLOSED
    }
}

/// The parameters of component `C` of tree `T`.
pub type ParamsOf<T, C> = <<T as Has<C>>::Member as Component>::Params;

/// The place of the jobs of component `C` in tree `T`.
pub type WorkOf<T, C> = <<T as Has<C>>::Member as Component>::Work;

/// Whether `C` declares a rate, or the target wants small code: one form of visit is then enough.
#[inline]
#[must_use]
pub const fn visits_at_rate<T: Has<C>, C: 'static>() -> bool {
    <T::Member as Component>::HZ.is_some() || cfg!(target_os = "none")
}

/// What is done with one component of tree `T` that is known only by its index.
pub trait Member<T: Layout> {
    /// The result.
    type Output;

    /// Does it with component `C`.
    fn visit<C: 'static>(self) -> Self::Output
    where
        T: Has<C>;
}

/// A component as a member of tree `T`; `#[component]` implements it for every tree that holds the component's children.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no component",
    label = "its impl block has no `#[component]`",
    note = "write `#[component]` on the impl block that holds its `step` or its states"
)]
pub trait MemberOf<T: Layout, B = <Self as Component>::Block>: Component {
    /// Links as the signatures write them, before two paths to one component are recognised as one.
    const WRITTEN: &'static [WrittenLink];
    /// Description of the component in that tree.
    const NODE: Node;
    /// Whether the component takes a `&Time`.
    const TIMED: bool;
    /// Whether a transition of the component changes which children are visited.
    const HAS_CHILDREN: bool = !Self::NODE.links.is_empty();
    /// Indices of the components whose rates the functions of this one borrow.
    const RATES: &'static [usize] = &[];
    /// Indices of the components whose ages the functions of this one take.
    const AGES: &'static [usize] = &[];

    /// Visits the children that are needed now and, if the component is due, runs it between them.
    fn pass<P: Probe>(cycle: &mut Cycle<'_, T, P>, visit: Visit);

    /// As `pass` in a steady tick, of a fixed component. The plan of a state machine with children is its state.
    #[inline]
    fn pass_steady<P: Probe, const PLAN: usize>(cycle: &mut Cycle<'_, T, P>, is_due: bool) {
        Self::pass(cycle, Visit { due: is_due, entering: false });
    }

    /// Runs a state machine from this progress on. That of a request is another function: with one call more the compiler would not make
    /// the loop a part of the visit.
    #[inline]
    fn proceed<P: Probe, const BY_REQUEST: bool>(_: &mut Cycle<'_, T, P>, _: Visit, _: Machine) {}

    /// Runs a state machine that goes to a state by request, without the transitions of the state in which it is.
    #[inline]
    fn go<P: Probe>(_: &mut Cycle<'_, T, P>) {}

    /// Calls the `#[start]` hooks.
    #[inline]
    fn start<P: Probe>(_: &mut Cycle<'_, T, P>) {}

    /// Calls the `#[stop]` hooks.
    #[inline]
    fn stop<P: Probe>(_: &mut Cycle<'_, T, P>) {}

    /// Passes the output at `index` to `sink`; returns whether it exists.
    fn read_output<S: OutputSink>(_tree: &T, _index: usize, _sink: &mut S) -> bool {
        false
    }

    /// Calls a modulation with arguments that are valid.
    fn modulate(_tree: &mut T, _index: usize, _arguments: &[Value]) {}
}

/// How a tree holds its components.
pub trait Layout: Sized + 'static {
    /// All the slots.
    #[doc(hidden)]
    type Slots;
    /// Nominal rate of ticks, 1/s.
    #[doc(hidden)]
    const CYCLE_HZ: f32;
    /// Number of links that end at each component.
    #[doc(hidden)]
    const ACTIVATORS: &'static [usize];
    /// The components in an order in which activators come before what they activate.
    #[doc(hidden)]
    const ORDER: &'static [u16];

    /// Whether a component has work beside the loop.
    #[doc(hidden)]
    const WORKS: bool = false;

    /// Whether a component takes the age of the one at each index.
    #[doc(hidden)]
    const AGED: &'static [bool] = &[];

    /// Whether visits of a component are put off to the end of the cycle.
    #[doc(hidden)]
    const DEFERS: bool = false;

    /// The plans of steady ticks.
    #[doc(hidden)]
    const PLANS: Plans = Plans::NONE;

    #[doc(hidden)]
    fn engine(&self) -> &Engine<Self>;
    #[doc(hidden)]
    fn engine_mut(&mut self) -> &mut Engine<Self>;
    #[doc(hidden)]
    fn visit_root<P: Probe>(cycle: &mut Cycle<'_, Self, P>);
    /// Visits the root in a steady tick.
    #[doc(hidden)]
    #[inline]
    fn run_steady<P: Probe>(_: &mut Cycle<'_, Self, P>) {}
    #[doc(hidden)]
    fn visit<P: Probe>(cycle: &mut Cycle<'_, Self, P>, index: usize);
    /// As `visit`, at the end of the cycle, of a component whose visits are put off.
    #[doc(hidden)]
    fn visit_deferred<P: Probe>(_: &mut Cycle<'_, Self, P>, _: usize) {}
    #[doc(hidden)]
    fn stop<P: Probe>(cycle: &mut Cycle<'_, Self, P>, index: usize);
    #[doc(hidden)]
    fn component_state(slots: &Self::Slots, index: usize) -> Option<&ComponentState>;
    /// Does something with the component at `index`; `None` if the tree lists fewer.
    #[doc(hidden)]
    fn member<M: Member<Self>>(index: usize, action: M) -> Option<M::Output>;
    #[doc(hidden)]
    fn hz(&self, index: usize) -> Option<f32>;
    #[doc(hidden)]
    fn set_hz(&mut self, index: usize, hz: Option<f32>);
}

/// The components of a tree and what is stored of them from cycle to cycle.
pub struct Engine<T: Layout> {
    pub(crate) store: Store<T>,
}

/// Owner of the components of tree `T`.
///
/// The cycle state lies beside the slots, so that a visit needs only one pointer.
pub(crate) struct Store<T: Layout> {
    cycle_state: CycleState,
    slots: T::Slots,
}

/// One component of a tree, its rate, its state, and its parameters if the tree is tunable.
pub struct Slot<C, S = (), W = ()> {
    state: ComponentState,
    rate: UnsafeCell<Rate<C>>,
    value: UnsafeCell<C>,
    /// In no `UnsafeCell`: a cycle only reads it. Parameters are plain values that need no drop, and the engine drops jobs; said
    /// here, it keeps the compiler from asking for these types of a listed type that is no component, once for each variable.
    params: ManuallyDrop<S>,
    work: ManuallyDrop<W>,
}

/// An exclusive borrow of a store, from which components can be borrowed.
pub(crate) struct ExclusiveStore<'t, T: Layout> {
    store: &'t Store<T>,
    exclusive: PhantomData<&'t mut T::Slots>,
}

/// A cycle of tree `T` in progress, watched by `P`.
///
/// It is forgotten when the cycle ends. So it is dropped only if the tick unwinds, and then it marks the tree.
pub struct Cycle<'t, T: Layout, P> {
    pub(crate) store: ExclusiveStore<'t, T>,
    pub(crate) probe: &'t mut P,
}

/// What a component does when it is visited.
#[derive(Clone, Copy)]
pub struct Visit {
    /// The component is to run.
    pub due: bool,
    /// A state machine begins in its initial state.
    pub entering: bool,
}

/// Progress of a state machine in its run.
#[derive(Clone, Copy)]
pub struct Machine {
    /// Index of the state.
    pub state: usize,
    /// The entry hooks of the state are still to be called.
    pub entering: bool,
    /// A transition was taken in this run.
    pub moved: bool,
}
