//! Children with `writers = last`: they are visited at the end of the cycle, after all components that write them.

use super::layout::{Cycle, Has, Layout};
use crate::component::Component;
use crate::graph::{InForce, Node};
use crate::probe::Probe;

impl<T: Layout, P: Probe> Cycle<'_, T, P> {
    /// Puts the visit of `C` off to the end of the cycle.
    #[inline]
    pub fn defer<C: 'static>(&mut self)
    where
        T: Has<C>,
    {
        self.store.component_state::<C>().activation().defer();
    }
}

/// Whether visits of `C` are put off.
#[must_use]
pub const fn is_deferred<T: Has<C>, C: 'static>() -> bool {
    matches!(<T::Member as Component>::WRITERS, Some(InForce::Last))
}

/// Returns whether a tree has a component whose visits are put off.
#[must_use]
pub const fn deferred(nodes: &[Node]) -> bool {
    let mut index = 0;
    while index < nodes.len() && !nodes[index].is_last() {
        index += 1;
    }
    index < nodes.len()
}

/// Visits what was put off, activators first.
pub(super) fn visit_deferred<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>) {
    for index in T::ORDER.iter().map(|&index| usize::from(index)) {
        if cycle.store.state_at(index).is_some_and(|state| state.activation().takes_deferred()) {
            T::visit_deferred(cycle, index);
        }
    }
}
