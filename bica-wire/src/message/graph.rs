//! The graph of a tree.

use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// One item of the graph of a tree. All numbers are indices into lists, as in [`bica_core::graph`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum GraphItem<'a> {
    /// A component.
    Component {
        /// Index in the tree's list; components are sent in this order.
        index: u8,
        /// Name.
        name: &'a str,
        /// Declared rate, Hz; none: every cycle.
        hz: Option<f32>,
        /// Declared time budget of a run, µs.
        budget_us: Option<f32>,
        /// Whether it is the root.
        root: bool,
    },
    /// An activation link between two components.
    Link {
        /// Index of the activating component.
        from: u8,
        /// Index of the activated component.
        to: u8,
        /// True: modulation (stepped after `from`); false: requirement (stepped before `from`).
        modulation: bool,
        /// Index of the only state with this link; none: the link exists in every state.
        state: Option<u8>,
    },
    /// A state of a component.
    State {
        /// Index of the component.
        component: u8,
        /// Index in the component's list; states are sent in this order.
        index: u8,
        /// Name.
        name: &'a str,
        /// Whether it is the initial state.
        initial: bool,
    },
    /// A transition between two states of a component.
    Transition {
        /// Index of the component.
        component: u8,
        /// Index of the source state.
        from: u8,
        /// Index of the target state.
        to: u8,
        /// Name.
        name: &'a str,
    },
    /// The end of the graph.
    End {
        /// Number of items before this one.
        items: u16,
    },
}
