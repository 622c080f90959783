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

fn names(edge: &Edge) -> Option<[f32; 4]> {
    let longest = edge.labels.iter().map(|label| label.text.len()).max()?;
    Some(around(edge.label_at, (LETTER.0 * longest as f32, LETTER.1 * edge.labels.len() as f32)))
}

/// Returns the number of states that a line crosses.
fn crossed(edge: &Edge, nodes: &[Node]) -> usize {
    let parts = edge.points.windows(2).flat_map(|ends| {
        let [from, to] = [ends[0], ends[1]];
        (0..=16_u8)
            .map(f32::from)
            .map(move |at| (from.0 + (to.0 - from.0) * at / 16.0, from.1 + (to.1 - from.1) * at / 16.0))
    });
    let parts: Vec<(f32, f32)> = parts.collect();
    let is_in = |node: &&Node| {
        let [left, top, right, bottom] = around(node.centre, node.size);
        parts.iter().any(|(x, y)| left < *x && *x < right && top < *y && *y < bottom)
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
            let Some(own) = names(edge) else { continue };
            for node in &diagram.nodes {
                assert!(!overlap(own, around(node.centre, node.size)), "{path}: {:?} and {}", edge.labels, node.name);
            }
            for other in diagram.edges[index + 1..].iter().filter_map(names) {
                assert!(!overlap(own, other), "{path}: {:?}", edge.labels);
            }
        }
    }
}

/// The distance counts only transitions that name the states they leave.
#[test]
fn rows_follow_the_distance_from_the_initial_state() {
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
        for (state, far) in distance.iter().enumerate() {
            let name = &component.states[state].function.name.text;
            let nearer = distance.iter().zip(&placed).filter(|(other, _)| *other < far);
            assert!(nearer.map(|(_, place)| place.y).all(|y| y <= placed[state].y), "{name}");
        }
        // The links of a drawn state are those of the graph without transitions.
        let nodes = Diagram::of(&component, &Layout::default()).nodes;
        let alone = Component { transitions: Vec::new(), ..component.clone() };
        assert_eq!(nodes.into_iter().flat_map(|node| node.links).collect::<Vec<_>>(), alone.links());
        (hooks, from_any) = (hooks + component.hooks.len(), from_any + of_any.len());
    }
    assert!(hooks > 0 && from_any > 0, "{hooks} hooks, {from_any} transitions from all states");
}
