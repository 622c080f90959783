//! The graph of a tree.

use bica_core::Place;
use bica_core::graph::{End, QueryKind};
use bica_core::params::Kind;
use bica_core::visual::Placement;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use super::Value;

/// One item of the graph of a tree. All numbers are indices into lists, as in [`bica_core::graph`].
///
/// A [`Doc`](Self::Doc) belongs to the last item before it that is no `Doc`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum GraphItem<'a> {
    /// The tree; the first item.
    Tree {
        /// Name.
        name: &'a str,
        /// Nominal rate of ticks, Hz.
        cycle_hz: f32,
        /// Longest time of one cycle, ms.
        budget_ms: Option<f32>,
        /// Whether parameters can be changed at run time.
        tunable: bool,
        /// Number of components.
        components: u16,
    },
    /// A part of a doc comment. Several in succession are one text.
    Doc {
        /// The text.
        text: &'a str,
    },
    /// A component.
    Component {
        /// Index in the tree's list; components are sent in this order.
        index: u16,
        /// Name.
        name: &'a str,
        /// Declared rate, Hz; none: every cycle.
        hz: Option<f32>,
        /// Declared time budget of a run, µs.
        budget_us: Option<f32>,
        /// Whether it is the root.
        root: bool,
        /// Whether its state machine continues in the state in which it became latent.
        resume: bool,
    },
    /// An activation link between two components.
    Link {
        /// Index of the activating component.
        from: u16,
        /// Index of the activated component.
        to: u16,
        /// True: modulation (stepped after `from`); false: requirement (stepped before `from`).
        modulation: bool,
        /// Index of the only state with this link; none: the link exists in every state.
        state: Option<u16>,
    },
    /// A state of a component.
    State {
        /// Index of the component.
        component: u16,
        /// Index in the component's list; states are sent in this order.
        index: u16,
        /// Name.
        name: &'a str,
        /// Whether it is the initial state.
        initial: bool,
        /// Whether it is marked to have no transition out of it.
        last: bool,
        /// Result with which the machine ends in it.
        end: Option<End>,
        /// Function that runs before the transitions that leave it.
        before: Option<&'a str>,
    },
    /// A transition between two states of a component.
    Transition {
        /// Index of the component.
        component: u16,
        /// Index of the source state.
        from: u16,
        /// Index of the target state.
        to: u16,
        /// Name.
        name: &'a str,
        /// Shortest time in the source state, ms; of a timer that is a parameter its default.
        after_ms: Option<u32>,
        /// Index of the component's parameter that is the shortest time.
        after: Option<u16>,
        /// Index of the component whose result it waits for, and the result.
        when: Option<(u16, End)>,
        /// How often it is taken in a row.
        times: Option<u8>,
        /// Type of what it carries to the target state, as in the source text.
        carries: Option<&'a str>,
    },
    /// A parameter of a component.
    Param {
        /// Index of the component.
        component: u16,
        /// Index among the component's parameters; parameters are sent in this order.
        index: u16,
        /// Name of the struct that contains it.
        group: &'a str,
        /// Name.
        name: &'a str,
        /// Unit; none for a pure number.
        unit: Option<&'a str>,
        /// Kind and range; of a choice the number of variants.
        kind: Kind<u16>,
        /// Default value.
        default: Value,
    },
    /// A variant of the last parameter or argument, whose kind is a choice; variants are sent in the order of their
    /// indices.
    Variant {
        /// Name.
        name: &'a str,
    },
    /// An output of a component.
    Output {
        /// Index of the component.
        component: u16,
        /// Index among the component's outputs.
        index: u16,
        /// Name.
        name: &'a str,
        /// Unit; none for a value without one.
        unit: Option<&'a str>,
        /// Type of the value, as in the source text.
        type_name: &'a str,
        /// Visual type and frames; none for an output that is not drawn.
        placement: Option<Placement<'a>>,
    },
    /// A modulation of a component.
    Modulation {
        /// Index of the component.
        component: u16,
        /// Index among the component's modulations.
        index: u16,
        /// Name.
        name: &'a str,
        /// Whether it stops the robot.
        stops: bool,
        /// Whether tools drive the robot by it.
        drives: bool,
    },
    /// An action of a simulated world. Actions follow all components, in the order of their indices.
    Action {
        /// Name.
        name: &'a str,
        /// Item of the true state that it moves.
        moves: Option<&'a str>,
    },
    /// Place from which a tool may take the value of the last argument. A microcontroller sends none.
    Place(Place<'a>),
    /// An argument of the last modulation or action.
    Argument {
        /// Name.
        name: &'a str,
        /// Unit; none for a pure number.
        unit: Option<&'a str>,
        /// Kind and range; of a choice the number of variants.
        kind: Kind<u16>,
        /// Default value.
        default: Value,
    },
    /// The end of the graph.
    End {
        /// Number of items before this one.
        items: u32,
    },
    /// A role by which the last link is written; a link may have several. A microcontroller sends none.
    Role {
        /// Name.
        name: &'a str,
    },
    /// The function of the last component that runs beside the loop. A microcontroller sends none.
    Work {
        /// Name.
        name: &'a str,
        /// Declared time of a job, ms.
        takes_ms: u32,
        /// Whether it runs in slices.
        slices: bool,
        /// Type of the result, as in the source text.
        result: &'a str,
    },
    /// The type of the last component, whose name is another one. A microcontroller sends none.
    Kind {
        /// The type as the tree lists it.
        name: &'a str,
    },
    /// An age or outcome for which the last component asks. A microcontroller sends none.
    Query {
        /// Index of the other component.
        of: u16,
        /// What is asked.
        kind: QueryKind,
    },
    /// One of several components that write the last component in one cycle, in the order in which they run. A microcontroller sends
    /// none.
    Writer {
        /// Index of the component that writes.
        by: u16,
        /// Whether its values are in force.
        in_force: bool,
    },
}
