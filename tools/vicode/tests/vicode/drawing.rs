//! Drawings that can be read.

use bica_vicode::draw::{Diagram, Edge, Node, automatic};
use bica_vicode::model::Component;
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
    let longest = edge.labels.iter().map(|label| label.text.len()).max().unwrap();
    around(edge.label_at, (LETTER.0 * longest as f32, LETTER.1 * edge.labels.len() as f32))
}

/// Returns the number of states that a curve crosses without its end points, which lie at states.
fn crossed(edge: &Edge, nodes: &[Node]) -> usize {
    let inner = &edge.points[1..edge.points.len() - 1];
    let is_in = |node: &&Node| {
        let [left, top, right, bottom] = around(node.centre, node.size);
        inner.iter().any(|(x, y)| left < *x && *x < right && top < *y && *y < bottom)
    };
    nodes.iter().filter(is_in).count()
}

#[test]
fn curves_cross_no_state_and_names_cover_nothing() {
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

/// The distance counts only transitions that name the states they leave.
#[test]
fn column_of_a_state_is_its_distance_from_the_start() {
    let texts = ["player", "examples"].into_iter().flat_map(components);
    let machines = texts.flat_map(|(_, text)| read(&text).components).filter(Component::is_machine);
    let (mut hooks, mut from_any) = (0, 0);
    for component in machines {
        let initial = component.states.iter().position(|state| state.initial).unwrap_or(0);
        let (of_any, edges): (Vec<_>, Vec<_>) = component.machine().edges.into_iter().partition(|edge| edge.any);
        let placed = automatic(&component, &Layout::default());
        let mut distance = vec![usize::MAX; placed.len()];
        distance[initial] = 0;
        for _ in &placed {
            for edge in &edges {
                distance[edge.to] = distance[edge.to].min(distance[edge.from].saturating_add(1));
            }
        }
        for (state, far) in distance.iter().enumerate().filter(|(_, far)| **far != usize::MAX) {
            let name = &component.states[state].function.name.text;
            assert_eq!(placed[state].x, placed[initial].x + 340 * *far as i32, "{name}");
        }
        // The links of a drawn state are those of the graph without transitions.
        let nodes = Diagram::of(&component, &Layout::default()).nodes;
        let alone = Component { transitions: Vec::new(), ..component.clone() };
        assert_eq!(nodes.into_iter().flat_map(|node| node.links).collect::<Vec<_>>(), alone.links());
        (hooks, from_any) = (hooks + component.hooks.len(), from_any + of_any.len());
    }
    assert!(hooks > 0 && from_any > 0, "{hooks} hooks, {from_any} transitions from all states");
}
