//! A tree of components: what `activation_tree!` writes, and what a program does with it.

use embassy_time::Instant;

use crate::clock::Clock;
use crate::component::Component;
use crate::cycle::{Cycle, Turn};
use crate::engine::Engine;
use crate::graph::{Graph, Node};
use crate::hold::Hold;
use crate::id::ComponentId;
use crate::loan::Slot;
use crate::probe::Probe;
use crate::rate::Rate;
use crate::written::WrittenLink;

/// A tree of components, made by `activation_tree!`.
///
/// Between two ticks the owner fills in what was sensed and reads what is to be done; [`tick`](Tree::tick) thinks.
/// A tree does no input or output and reads no clock: the same inputs at the same instants give the same outputs, bit
/// for bit.
pub trait Tree: Layout {
    /// All that is known of the tree before it runs.
    const GRAPH: Graph;
    /// How many components the tree lists.
    const COUNT: usize = Self::GRAPH.nodes.len();

    /// One cycle: visits the root, and through it what is active.
    ///
    /// A clock that stands still or jumps is tolerated; see [`Rate`].
    #[inline]
    fn tick(&mut self, now: Instant) {
        self.tick_with(now, &mut ());
    }

    /// One cycle, watched by `probe`.
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

    /// The rate of component `C`.
    fn rate<C: 'static>(&self) -> &Rate<C>
    where
        Self: Has<C>,
    {
        self.engine().store.rate()
    }

    /// The rate of component `C`, to be modulated.
    fn rate_mut<C: 'static>(&mut self) -> &mut Rate<C>
    where
        Self: Has<C>,
    {
        self.engine_mut().store.rate_mut()
    }

    /// The name of component `C` for what works with any component.
    #[must_use]
    fn id<C: 'static>() -> ComponentId
    where
        Self: Has<C>,
    {
        ComponentId::new(Self::INDEX)
    }

    /// Holds component `C` active or latent from the next cycle on, or leaves it to the tree again.
    fn hold<C: 'static>(&mut self, hold: Hold)
    where
        Self: Has<C>,
    {
        self.hold_at(Self::id::<C>(), hold);
    }

    /// As [`hold`](Tree::hold), by name; does nothing for a component that the tree does not list.
    fn hold_at(&mut self, component: ComponentId, hold: Hold) {
        self.engine_mut().hold(component, hold);
    }

    /// How the component is held.
    fn held(&self, component: ComponentId) -> Hold {
        self.engine().held(component)
    }

    /// Whether the component was visited in the last cycle.
    fn is_active(&self, component: ComponentId) -> bool {
        self.engine().is_active(component)
    }

    /// The components that were visited in the last cycle, in the order of the tree's list.
    fn active(&self) -> impl Iterator<Item = ComponentId> {
        (0..Self::COUNT).map(ComponentId::new).filter(|&component| self.is_active(component))
    }

    /// The state of a state machine, an index in [`Node::states`]; of a latent one the state that it was in.
    ///
    /// `None` for a component that is no state machine or was never active.
    fn state(&self, component: ComponentId) -> Option<usize> {
        self.status(component)?.state
    }

    /// All that a monitor shows of a component; `None` for one that the tree does not list.
    fn status(&self, component: ComponentId) -> Option<Status> {
        let clock = Self::clock(self.engine().store.slots(), component.index())?;
        Some(Status {
            active: self.is_active(component),
            held: self.held(component),
            state: clock.state(),
            since: clock.since(),
            hz: Self::hz(self, component.index()),
        })
    }

    /// Modulates the rate of a component by name, as [`Rate::set`] does; does nothing for one that the tree does not
    /// list.
    fn set_rate_at(&mut self, component: ComponentId, hz: f32) {
        Self::set_hz(self, component.index(), hz);
    }
}

/// A component as it is now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Status {
    /// Whether it was visited in the last cycle.
    pub active: bool,
    /// How it is held.
    pub held: Hold,
    /// The state that its machine is in, or was in when it became latent: an index in [`Node::states`].
    pub state: Option<usize>,
    /// Since when the machine is in that state; without states, when it last became active. `None` before it first was.
    pub since: Option<Instant>,
    /// Runs per second that are asked of it now; `None` is a run in every cycle.
    pub hz: Option<f32>,
}

/// Tree `Self` holds component `C`.
#[diagnostic::on_unimplemented(
    message = "activation tree `{Self}` does not hold component `{C}`",
    label = "`{C}` is not in the list",
    note = "add `{C}` to `components: [...]` of `{Self}`"
)]
pub trait Has<C: 'static>: Layout {
    /// `C`, known to be a component whose children the tree holds. It is the one place that demands this.
    #[doc(hidden)]
    type Member: Wired<Self>;

    /// The component's place in the tree's list.
    const INDEX: usize;

    #[doc(hidden)]
    fn slot(slots: &Self::Slots) -> &Slot<C>;

    #[doc(hidden)]
    fn visit<P: Probe>(cycle: &mut Cycle<'_, Self, P>);
}

/// A component as a part of tree `T`; written by `#[component]` for every tree that holds what the component names.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no component",
    label = "its impl block bears no `#[component]`",
    note = "write `#[component]` on the impl block that holds its `step` or its states"
)]
pub trait Wired<T: Layout>: Component {
    /// The links as the signatures write them, before two paths to one component are recognised as one.
    const WRITTEN: &'static [WrittenLink];
    /// The component's description in that tree.
    const NODE: Node;
    /// Whether the component asks for the time.
    const TIMED: bool;

    /// Visits the children that are needed now and, if it is due, runs the component between them.
    fn pass<P: Probe>(cycle: &mut Cycle<'_, T, P>, turn: Turn);

    /// Calls the `#[start]` hooks.
    #[inline]
    fn start<P: Probe>(_: &mut Cycle<'_, T, P>) {}

    /// Calls the `#[stop]` hooks.
    #[inline]
    fn stop<P: Probe>(_: &mut Cycle<'_, T, P>) {}
}

/// How a tree holds its components.
pub trait Layout: Sized + 'static {
    /// All the slots.
    #[doc(hidden)]
    type Slots;
    /// How many links end at each component.
    #[doc(hidden)]
    const ACTIVATORS: &'static [usize];
    /// The components in an order in which activators come before what they activate.
    #[doc(hidden)]
    const ORDER: &'static [u16];

    #[doc(hidden)]
    fn engine(&self) -> &Engine<Self>;
    #[doc(hidden)]
    fn engine_mut(&mut self) -> &mut Engine<Self>;
    #[doc(hidden)]
    fn visit_root<P: Probe>(cycle: &mut Cycle<'_, Self, P>);
    #[doc(hidden)]
    fn visit<P: Probe>(cycle: &mut Cycle<'_, Self, P>, index: usize);
    #[doc(hidden)]
    fn stop<P: Probe>(cycle: &mut Cycle<'_, Self, P>, index: usize);
    #[doc(hidden)]
    fn clock(slots: &Self::Slots, index: usize) -> Option<&Clock>;
    #[doc(hidden)]
    fn hz(&self, index: usize) -> Option<f32>;
    #[doc(hidden)]
    fn set_hz(&mut self, index: usize, hz: f32);
}
