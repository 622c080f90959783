//! One component of a tree, from outside.

use core::fmt;
use core::ops::{Deref, DerefMut};

use super::layout::Layout;
use super::{Tree, going, tuning};
use crate::hold::Hold;
use crate::id::ComponentId;
use crate::key::Key;
use crate::params::Value;
use crate::refusal::Refusal;

/// A component of a tree between two cycles: [`Tree::of`] and [`Tree::at`] give one that reads, [`Tree::of_mut`] and
/// [`Tree::at_mut`] one that writes, too.
#[derive(Clone, Copy)]
pub struct Handle<R> {
    tree: R,
    component: ComponentId,
}

impl<R: Deref<Target: Tree>> Handle<R> {
    pub(super) const fn new(tree: R, component: ComponentId) -> Self {
        Self { tree, component }
    }

    /// Returns the identifier of the component.
    #[must_use]
    pub const fn id(&self) -> ComponentId {
        self.component
    }

    /// Returns whether the component was visited in the last cycle.
    #[must_use]
    pub fn is_active(&self) -> bool {
        self.tree.engine().is_active(self.component)
    }

    /// Returns the name of the state, the name of the function with `#[state]`; of a latent state machine that of the state in which
    /// it became latent.
    ///
    /// `None` for a component that has no states or was never active.
    #[must_use]
    pub fn state_name(&self) -> Option<&'static str> {
        let state = self.tree.state(self.component)?;
        R::Target::GRAPH.nodes.get(self.component.index())?.states.get(state).map(|state| state.name)
    }

    /// Returns the value of a parameter; `None` if there is none. An index counts through the component's
    /// [groups](crate::graph::Node::params).
    #[must_use]
    pub fn param(&self, parameter: impl Key) -> Option<Value> {
        tuning::get(&*self.tree, self.component, parameter)
    }
}

impl<R: DerefMut<Target: Tree>> Handle<R> {
    /// Holds the component active or latent from the next cycle on, or releases it.
    pub fn hold(&mut self, hold: Hold) {
        self.tree.engine_mut().hold(self.component, hold);
    }

    /// Makes the active state machine go to a state in the next cycle, in a run of its own, whether it is due or not: with the exit hooks
    /// of the state that it leaves and the entry hooks of the one that it enters, as by a transition whose condition holds. If the
    /// machine becomes latent or begins in that cycle, nothing happens.
    ///
    /// # Errors
    /// If there is no such state, if the machine is latent, if the state takes what a transition found (`Found<T>`), if another machine of
    /// the tree goes to a state in that cycle, or on a microcontroller.
    pub fn go(&mut self, state: impl Key) -> Result<(), Refusal> {
        going::request(&*self.tree, self.component, state)
    }

    /// Sets the rate, as [`Rate::set`](crate::Rate::set) does; `None` is the declared rate.
    pub fn set_rate(&mut self, hz: Option<f32>) {
        self.tree.set_hz(self.component.index(), hz);
    }
}

impl<R> fmt::Debug for Handle<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Handle").field(&self.component).finish()
    }
}
