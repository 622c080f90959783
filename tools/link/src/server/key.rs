//! Data that a monitor watches, other than images, transitions and stops.

use bica_wire::message::{COSTS_CYCLES, ExtraKind, WatchOutput};

/// Data that a monitor watches, other than images, transitions and stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Key {
    /// The snapshot: states of all components.
    Snapshot,
    /// An output: component and index.
    Output(u16, u16),
    /// The conditions of a component.
    Conditions(u16),
    /// The costs.
    Costs,
    /// The true state of the world.
    Truth,
}

impl Key {
    /// Returns the key that a message requests, and n for every n-th cycle.
    pub(super) const fn of_output(watch: WatchOutput) -> (Self, u16) {
        (Self::Output(watch.component, watch.output), watch.every)
    }

    /// Returns the key that a message requests, and n for every n-th cycle; none for images, transitions and stops.
    pub(super) const fn of_extra(kind: ExtraKind, every: u16) -> Option<(Self, u16)> {
        Some(match kind {
            ExtraKind::Conditions { component } => (Self::Conditions(component), every),
            // All monitors share one window.
            ExtraKind::Costs => (Self::Costs, if every == 0 { 0 } else { COSTS_CYCLES }),
            ExtraKind::Truth => (Self::Truth, every),
            ExtraKind::Images | ExtraKind::Taken | ExtraKind::Stop(_) => return None,
        })
    }
}
