//! Drawings that can be read.

use bica_vicode::draw::{Diagram, Edge, Node, automatic};
use bica_vicode::model::{Component, Graph, Link, Sources};
use bica_vicode::{Layout, read};

use crate::sources::{components, text};

/// Width of a letter and height of a line of a name, points.
const LETTER: (f32, f32) = (6.0, 13.0);

fn diagram(path: &str) -> Diagram {
    let model = read(&text(path));
    Diagram::of(&model.components[0], &Layout::default())
}

/// Left, top, right, bottom.
fn around((x, y): (f32, f32), (width, height): (f32, f32)) -> [f32; 4] {
    [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0]
}

fn overlap(a: [f32; 4], b: [f32; 4]) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

fn names(edge: &Edge) -> [f32; 4] {
    let longest = edge.labels.iter().map(String::len).max().unwrap();
    around(edge.label_at, (LETTER.0 * longest as f32, LETTER.1 * edge.labels.len() as f32))
}

/// The number of states that the inner part of a curve crosses: its ends lie at states.
fn crossed(edge: &Edge, nodes: &[Node]) -> usize {
    let inner = &edge.points[1..edge.points.len() - 1];
    let is_in = |node: &&Node| {
        let [left, top, right, bottom] = around(node.centre, node.size);
        inner.iter().any(|(x, y)| left < *x && *x < right && top < *y && *y < bottom)
    };
    nodes.iter().filter(is_in).count()
}

#[test]
fn curves_cross_no_state_and_names_cover_neither_states_nor_names() {
    for path in ["examples/goalkeeper/src/goalkeeper.rs", "player/src/behaviour/player.rs"] {
        let diagram = diagram(path);
        assert!(diagram.edges.len() > 15, "{path}: {}", diagram.edges.len());
        for (index, edge) in diagram.edges.iter().enumerate() {
            assert_eq!(crossed(edge, &diagram.nodes), 0, "{path}: {:?}", edge.labels);
            let own = names(edge);
            for node in &diagram.nodes {
                assert!(!overlap(own, around(node.centre, node.size)), "{path}: {:?} and {}", edge.labels, node.name);
            }
            for other in &diagram.edges[index + 1..] {
                assert!(!overlap(own, names(other)), "{path}: {:?} and {:?}", edge.labels, other.labels);
            }
        }
    }
}

/// All components of the workspace that are machines.
fn machines() -> Vec<Component> {
    let texts = ["player", "examples"].into_iter().flat_map(components);
    texts.flat_map(|(_, text)| read(&text).components).filter(Component::is_machine).collect()
}

#[test]
fn a_state_has_the_links_of_the_graph_without_transitions() {
    let machines = machines();
    for component in &machines {
        let mut alone = component.clone();
        alone.transitions.clear();
        let expected = Graph::of(&alone).links;
        let nodes = Diagram::of(component, &Layout::default()).nodes;
        let links: Vec<Link> = nodes.into_iter().flat_map(|node| node.links).collect();
        assert_eq!(links, expected, "{}", component.name.text);
    }
    let hooks: usize = machines.iter().map(|component| component.hooks.len()).sum();
    assert!(hooks > 0 && machines.len() > 5, "{hooks} hooks, {} machines", machines.len());
}

#[test]
fn the_layout_follows_from_the_transitions_that_name_the_states_they_leave() {
    let mut changed = 0;
    for component in machines() {
        let states: Vec<&str> = component.states.iter().map(|state| state.function.name.text.as_str()).collect();
        let placed = automatic(&component, &Layout::default());
        // A transition from all states joins each state with its target: it moves none.
        let mut named = component.clone();
        named.transitions.iter_mut().for_each(|one| one.arrows.retain(|arrow| arrow.from != Sources::Any));
        assert_eq!(automatic(&named, &Layout::default()), placed, "{states:?}");
        // Column by column: the distance from the initial state over the edges of the graph.
        let initial = component.states.iter().position(|state| state.initial).unwrap_or(0);
        let edges = Graph::of(&named).edges;
        let mut distance = vec![usize::MAX; states.len()];
        distance[initial] = 0;
        for _ in &states {
            for edge in &edges {
                distance[edge.to] = distance[edge.to].min(distance[edge.from].saturating_add(1));
            }
        }
        for (state, far) in distance.iter().enumerate().filter(|(_, far)| **far != usize::MAX) {
            assert_eq!(placed[state].x, placed[initial].x + 340 * *far as i32, "{}", states[state]);
        }
        changed += usize::from(named != component);
    }
    assert!(changed > 0, "no machine has a transition from all states");
}
