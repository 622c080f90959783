//! A tree, told fact by fact.

use bica_core::graph::{Graph, LinkKind, Node};

use crate::message::Fact;

/// Everything about a tree that a monitor needs: its components, then for each its links, states and transitions, then
/// the end.
///
/// Places beyond 255 do not fit the wire; a tree that large is cut there.
pub fn describe(graph: &'static Graph) -> impl Iterator<Item = Fact<'static>> {
    let nodes = || (0..=u8::MAX).zip(graph.nodes);
    let components = nodes().map(|(index, node)| component(index, node, graph.root == usize::from(index)));
    let facts = components.chain(nodes().flat_map(|(index, node)| parts(index, node)));
    let end = Fact::End { facts: facts.clone().count() as u16 };
    facts.chain([end])
}

fn component(index: u8, node: &'static Node, root: bool) -> Fact<'static> {
    Fact::Component { index, name: node.name, hz: node.hz, budget_us: node.budget_us, root }
}

fn parts(component: u8, node: &'static Node) -> impl Iterator<Item = Fact<'static>> + Clone {
    let links = node.links.iter().map(move |link| Fact::Link {
        from: component,
        to: link.to as u8,
        modulation: link.kind == LinkKind::Modulation,
        state: link.state.map(|state| state as u8),
    });
    let states = (0..=u8::MAX).zip(node.states).map(move |(index, state)| Fact::State {
        component,
        index,
        name: state.name,
        initial: state.initial,
    });
    let transitions = node.transitions.iter().map(move |transition| Fact::Transition {
        component,
        from: transition.from as u8,
        to: transition.to as u8,
        name: transition.name,
    });
    links.chain(states).chain(transitions)
}
