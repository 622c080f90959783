//! The graph of a tree as a sequence of messages.

use bica_core::graph::{Graph, LinkKind, Node};

use crate::message::GraphItem;

/// Describes a tree: its components, then for each component its links, states and transitions, then
/// [`GraphItem::End`].
///
/// An index occupies one byte on the wire: components and states after the 256th are left out.
pub fn describe(graph: &'static Graph) -> impl Iterator<Item = GraphItem<'static>> {
    let nodes = || (0..=u8::MAX).zip(graph.nodes);
    let components = nodes().map(|(index, node)| component(index, node, graph.root == usize::from(index)));
    let items = components.chain(nodes().flat_map(|(index, node)| parts(index, node)));
    let end = GraphItem::End { items: items.clone().count() as u16 };
    items.chain([end])
}

fn component(index: u8, node: &'static Node, root: bool) -> GraphItem<'static> {
    GraphItem::Component { index, name: node.name, hz: node.hz, budget_us: node.budget_us, root }
}

fn parts(component: u8, node: &'static Node) -> impl Iterator<Item = GraphItem<'static>> + Clone {
    let links = node.links.iter().map(move |link| GraphItem::Link {
        from: component,
        to: link.to as u8,
        modulation: link.kind == LinkKind::Modulation,
        state: link.state.map(|state| state as u8),
    });
    let states = (0..=u8::MAX).zip(node.states).map(move |(index, state)| GraphItem::State {
        component,
        index,
        name: state.name,
        initial: state.initial,
    });
    let transitions = node.transitions.iter().map(move |transition| GraphItem::Transition {
        component,
        from: transition.from as u8,
        to: transition.to as u8,
        name: transition.name,
    });
    links.chain(states).chain(transitions)
}
