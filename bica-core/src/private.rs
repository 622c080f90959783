//! What generated code uses. It is no part of the public interface and changes without notice.

pub use crate::__visit_functions as visit_functions;
pub use crate::check::{activators, check, ranks};
pub use crate::component::{Component, Time};
pub use crate::graph::{Graph, Link, LinkKind, Node, State, Transition};
pub use crate::probe::Probe;
pub use crate::rate::Rate;
pub use crate::tree::borrow::{Read, Slot, Write, WriteRate, assert_distinct};
pub use crate::tree::component_state::ComponentState;
pub use crate::tree::cycle::{Cycle, Visit, is_shared, visits_at_rate};
pub use crate::tree::cycle_state::VisitOutcome;
pub use crate::tree::engine::Engine;
pub use crate::tree::{Has, Layout, MemberOf, Tree};

/// Returns a doc comment; nothing with the feature `terse`.
#[must_use]
pub const fn doc(text: &'static str) -> &'static str {
    if cfg!(feature = "terse") { "" } else { text }
}

/// Returns the node of `C` in tree `T`, under the name that the list gives it.
#[must_use]
pub const fn node<T: Has<C>, C: 'static>(name: &'static str) -> Node {
    Node { name, ..<T::Member as MemberOf<T>>::NODE }
}

/// Returns the rate of `C` in runs per second; `None` is every cycle.
pub fn hz<T: Tree + Has<C>, C: 'static>(tree: &T) -> Option<f32> {
    tree.rate::<C>().hz()
}

/// Sets the rate of `C`.
pub fn set_hz<T: Tree + Has<C>, C: 'static>(tree: &mut T, hz: f32) {
    tree.rate_mut::<C>().set_within(hz, <T::Member as Component>::HZ);
}

/// Returns the component of each rank: the inverse of `ranks`.
#[must_use]
pub const fn order<const N: usize>(ranks: &[usize; N]) -> [u16; N] {
    let mut order = [0; N];
    let mut index = 0;
    while index < N {
        order[ranks[index]] = index as u16;
        index += 1;
    }
    order
}
