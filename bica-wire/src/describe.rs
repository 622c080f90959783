//! The graph of a tree as a sequence of messages.

use bica_core::graph::{Graph, LinkKind, Node};
use bica_core::modulation::Modulation;
use bica_core::params::{Kind, Param};

use crate::message::{GraphItem, ParamKind, Value};
use crate::text::{parts, truncate};

/// Largest size of a part of a doc comment, bytes.
const DOC_BYTES: usize = 512;
/// Largest size of the name of a type, bytes. A longer one is cut.
const TYPE_BYTES: usize = 512;

/// Describes a tree: the tree, its components, then for each component its links, states, transitions, parameters,
/// information and modulations, then [`GraphItem::End`]. Doc comments follow what they document.
pub fn describe(graph: &'static Graph) -> impl Iterator<Item = GraphItem<'static>> {
    let nodes = || (0..=u16::MAX).zip(graph.nodes);
    let tree = GraphItem::Tree {
        name: graph.name,
        cycle_hz: graph.cycle_hz,
        budget_ms: graph.budget_ms,
        tunable: graph.tunable,
        components: graph.nodes.len() as u16,
    };
    let components = nodes().flat_map(|(index, node)| component(index, node, graph.root == usize::from(index)));
    let items = documented(tree, graph.doc).chain(components);
    let items = items.chain(nodes().flat_map(|(index, node)| contents(index, node)));
    let end = GraphItem::End { items: items.clone().count() as u32 };
    items.chain([end])
}

type Item = GraphItem<'static>;

/// An item and its doc comment in parts.
fn documented(item: Item, doc: &'static str) -> impl Iterator<Item = Item> + Clone {
    core::iter::once(item).chain(parts(doc, DOC_BYTES).map(|text| GraphItem::Doc { text }))
}

fn component(index: u16, node: &'static Node, root: bool) -> impl Iterator<Item = Item> + Clone {
    let Node { name, hz, budget_us, resume, .. } = *node;
    documented(GraphItem::Component { index, name, hz, budget_us, root, resume }, node.doc)
}

fn contents(component: u16, node: &'static Node) -> impl Iterator<Item = Item> + Clone {
    let links = node.links.iter().map(move |link| GraphItem::Link {
        from: component,
        to: link.to as u16,
        modulation: link.kind == LinkKind::Modulation,
        state: link.state.map(|state| state as u16),
    });
    links
        .chain(states(component, node))
        .chain(transitions(component, node))
        .chain(params(component, node))
        .chain(information(component, node))
        .chain(modulations(component, node))
}

fn states(component: u16, node: &'static Node) -> impl Iterator<Item = Item> + Clone {
    (0..=u16::MAX).zip(node.states).flat_map(move |(index, state)| {
        let (name, initial, last) = (state.name, state.initial, state.last);
        documented(GraphItem::State { component, index, name, initial, last }, state.doc)
    })
}

fn transitions(component: u16, node: &'static Node) -> impl Iterator<Item = Item> + Clone {
    node.transitions.iter().flat_map(move |transition| {
        let (from, to) = (transition.from as u16, transition.to as u16);
        let (name, after_ms) = (transition.name, transition.after_ms);
        documented(GraphItem::Transition { component, from, to, name, after_ms }, transition.doc)
    })
}

fn params(component: u16, node: &'static Node) -> impl Iterator<Item = Item> + Clone {
    let params = node.params.iter().flat_map(|group| group.params.iter().map(|param| (group.name, param)));
    (0..=u16::MAX).zip(params).flat_map(move |(index, (group, param))| {
        let Param { name, unit, .. } = *param;
        let (kind, default) = kind_and_default(param);
        documented(GraphItem::Param { component, index, group, name, unit, kind, default }, param.doc)
            .chain(variants(param))
    })
}

fn kind_and_default(param: &Param) -> (ParamKind, Value) {
    (ParamKind::of(&param.kind), Value::of(param.default).unwrap_or(Value::U32(0)))
}

fn variants(param: &'static Param) -> impl Iterator<Item = Item> + Clone {
    let variants = match param.kind {
        Kind::Choice { variants } => variants,
        _ => &[],
    };
    variants.iter().flat_map(|variant| documented(GraphItem::Variant { name: variant.name }, variant.doc))
}

fn information(component: u16, node: &'static Node) -> impl Iterator<Item = Item> + Clone {
    (0..=u16::MAX).zip(node.info).flat_map(move |(index, info)| {
        let (name, unit, type_name) = (info.name, info.unit, truncate(info.ty, TYPE_BYTES));
        documented(GraphItem::Info { component, index, name, unit, type_name }, info.doc)
    })
}

fn modulations(component: u16, node: &'static Node) -> impl Iterator<Item = Item> + Clone {
    (0..=u16::MAX).zip(node.modulations).flat_map(move |(index, modulation)| {
        let name = modulation.name;
        documented(GraphItem::Modulation { component, index, name }, modulation.doc).chain(arguments(modulation))
    })
}

fn arguments(modulation: &'static Modulation) -> impl Iterator<Item = Item> + Clone {
    modulation.arguments.iter().flat_map(|argument| {
        let Param { name, unit, .. } = *argument;
        let (kind, default) = kind_and_default(argument);
        documented(GraphItem::Argument { name, unit, kind, default }, argument.doc).chain(variants(argument))
    })
}
