//! The description of a tree of this program.

use std::borrow::ToOwned;
use std::format;
use std::vec::Vec;

use bica_core::action::Action;
use bica_core::graph::{self, Graph, Node};
use bica_core::{info, modulation, params};

use super::{
    Component, Description, Info, Link, Modulation, Param, Place, Placement, State, Transition, Variant, Variants,
};

impl Description {
    /// Describes a tree of this program.
    #[must_use]
    pub fn of(graph: &Graph) -> Self {
        Self {
            name: graph.name.to_owned(),
            doc: graph.doc.to_owned(),
            hash: format!("{:016x}", graph::hash(graph)),
            cycle_hz: graph.cycle_hz,
            budget_ms: graph.budget_ms,
            tunable: graph.tunable,
            root: graph.root,
            components: graph.nodes.iter().map(Component::from).collect(),
            actions: Vec::new(),
        }
    }

    /// Adds what can be done in the world.
    #[must_use]
    pub fn with_actions(self, actions: &[Action]) -> Self {
        let action = |Action { call, moves }: &Action| Modulation { moves: moves.map(str::to_owned), ..call.into() };
        Self { actions: actions.iter().map(action).collect(), ..self }
    }
}

impl From<&Node> for Component {
    fn from(node: &Node) -> Self {
        let params = node.params.iter().flat_map(|group| group.params.iter().map(|param| of_group(group.name, param)));
        Self {
            name: node.name.to_owned(),
            doc: node.doc.to_owned(),
            hz: node.hz,
            budget_us: node.budget_us,
            resume: node.resume,
            links: node.links.iter().map(Link::from).collect(),
            states: node.states.iter().map(State::from).collect(),
            transitions: node.transitions.iter().map(Transition::from).collect(),
            params: params.collect(),
            info: node.info.iter().map(Info::from).collect(),
            modulations: node.modulations.iter().map(Modulation::from).collect(),
        }
    }
}

impl From<&graph::Link> for Link {
    fn from(&graph::Link { to, kind, state }: &graph::Link) -> Self {
        Self { to, kind, state }
    }
}

impl From<&graph::State> for State {
    fn from(state: &graph::State) -> Self {
        let (name, doc) = (state.name.to_owned(), state.doc.to_owned());
        Self { name, doc, initial: state.initial, last: state.last }
    }
}

impl From<&graph::Transition> for Transition {
    fn from(transition: &graph::Transition) -> Self {
        let graph::Transition { name, doc, from, to, after_ms } = *transition;
        Self { name: name.to_owned(), doc: doc.to_owned(), from, to, after_ms }
    }
}

fn of_group(group: &str, param: &params::Param) -> Param {
    let variant = |variant: &params::Variant| Variant { name: variant.name.to_owned(), doc: variant.doc.to_owned() };
    Param {
        group: group.to_owned(),
        name: param.name.to_owned(),
        doc: param.doc.text().to_owned(),
        unit: param.unit.map(str::to_owned),
        kind: param.kind.map(|variants| Variants(variants.iter().map(variant).collect())),
        default: param.default,
        place: param.hint.place().map(Place::from),
        value: None,
    }
}

impl From<&info::Info> for Info {
    fn from(info: &info::Info) -> Self {
        let (name, doc, unit) = (info.name.to_owned(), info.doc.text().to_owned(), info.unit.map(str::to_owned));
        Self { name, doc, unit, type_name: info.ty.to_owned(), placement: info.placement.copied().map(Placement::from) }
    }
}

impl From<&modulation::Modulation> for Modulation {
    fn from(modulation: &modulation::Modulation) -> Self {
        Self {
            name: modulation.name.to_owned(),
            doc: modulation.doc.to_owned(),
            arguments: modulation.arguments.iter().map(|argument| of_group("", argument)).collect(),
            moves: None,
        }
    }
}
