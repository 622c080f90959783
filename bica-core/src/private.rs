//! What generated code uses. No part of the public interface: it changes without notice.

pub use crate::check::{check, ranks};
pub use crate::component::{Component, Time};
pub use crate::cycle::{Cycle, Turn};
pub use crate::engine::Engine;
pub use crate::graph::{Graph, Link, LinkKind, Node, State, Transition};
pub use crate::loan::{Pace, Read, Slot, Write};
pub use crate::probe::Probe;
pub use crate::rate::Rate;
pub use crate::set::words;
pub use crate::tree::{Has, Layout, Tree, Wired};

/// The state of what is in a slot.
#[must_use]
pub fn state<C>(slot: &Slot<C>) -> Option<usize> {
    slot.clock().state()
}
