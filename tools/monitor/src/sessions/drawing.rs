//! Layout of a tree for the page.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::sync::{LazyLock, Mutex};

use bica::check::CAPACITY;
use bica::graph::{Graph, Link, LinkKind, Node, State};
use bica_drawing::layout::{Kind, Layers, Placement, routes};
use bica_link::Description;

use crate::pages::lock;
use crate::protocol::{Drawing, DrawnBox, DrawnLink};

/// Largest number of different trees that are drawn in the life of the program: the graph of each stays in memory.
const MAX_TREES: usize = 64;

/// The links of a tree: for each component whether it has states, and its links.
type Shape = Vec<(bool, Vec<ShapeLink>)>;
/// Target, whether it is a modulation, and the only state with it.
type ShapeLink = (usize, bool, Option<usize>);

static GRAPHS: LazyLock<Mutex<HashMap<(usize, Shape), &'static Graph>>> = LazyLock::new(Mutex::default);

/// Returns where the components and links of a tree are drawn; nothing for a tree that is too large.
pub(super) fn draw(description: &Description) -> Drawing {
    let Some(graph) = graph(description) else { return Drawing::default() };
    let layers = Layers::new(graph);
    let (placement, routes) = (Placement::new(&layers), routes(graph, &layers));
    let drawn_box = |component: usize| {
        let (x, y) = placement.of(component);
        let kind = match Kind::of(graph, component) {
            Kind::Machine => "machine",
            Kind::Controller => "controller",
            Kind::Perception => "perception",
            Kind::Actuation => "actuation",
        };
        DrawnBox { x: x as f32, y: y as f32, kind: kind.to_owned() }
    };
    let mut links = Vec::new();
    for (from, node) in graph.nodes.iter().enumerate() {
        for (link, route) in node.links.iter().zip(&routes[from]) {
            let segments: Vec<_> = route.iter().map(|&index| placement.ends(&layers.segments[index])).collect();
            links.push(DrawnLink { from, to: link.to, path: path(&segments) });
        }
    }
    Drawing {
        width: placement.width as f32,
        height: placement.height as f32,
        boxes: (0..graph.nodes.len()).map(drawn_box).collect(),
        links,
    }
}

type Point = (f64, f64);

/// Returns the path of a link: a curve for each segment, and a line past the boxes between two segments.
fn path(segments: &[(Point, Point)]) -> String {
    let mut path = String::new();
    for ((x1, y1), (x2, y2)) in segments {
        let (upper, lower) = (y1 + (y2 - y1) * 0.45, y1 + (y2 - y1) * 0.55);
        let start = if path.is_empty() { 'M' } else { 'L' };
        // Writing to a string cannot fail.
        let _ = write!(path, "{start}{x1:.1} {y1:.1}C{x1:.1} {upper:.1} {x2:.1} {lower:.1} {x2:.1} {y2:.1}");
    }
    path
}

/// Returns a graph with the links of a description. Layouts need a graph with a static lifetime, so each different one is
/// leaked once.
fn graph(description: &Description) -> Option<&'static Graph> {
    let count = description.components.len();
    let root = description.root;
    if root >= count {
        return None;
    }
    let shape: Shape = description
        .components
        .iter()
        .map(|component| {
            let links = component.links.iter().filter(|link| link.to < count);
            (
                !component.states.is_empty(),
                links.map(|link| (link.to, link.kind == LinkKind::Modulation, link.state)).collect(),
            )
        })
        .collect();
    let links: usize = shape.iter().map(|(_, links)| links.len()).sum();
    if count > CAPACITY || links > 4 * CAPACITY {
        return None;
    }
    let mut graphs = lock(&GRAPHS);
    let (known, key) = (graphs.len(), (root, shape));
    if let Some(graph) = graphs.get(&key) {
        return Some(graph);
    }
    (known < MAX_TREES).then(|| {
        let graph = &*Box::leak(Box::new(leak(root, &key.1)));
        graphs.insert(key, graph);
        graph
    })
}

fn leak(root: usize, shape: &Shape) -> Graph {
    const STATES: &[State] = &[State { name: "", doc: "", initial: true, last: false }];
    let node = |(has_states, links): &(bool, Vec<ShapeLink>)| {
        let link = |&(to, modulation, state): &ShapeLink| {
            let kind = if modulation { LinkKind::Modulation } else { LinkKind::Requirement };
            Link { to, kind, state }
        };
        let links: Vec<Link> = links.iter().map(link).collect();
        Node { links: links.leak(), states: if *has_states { STATES } else { &[] }, ..Node::new("") }
    };
    let nodes: Vec<Node> = shape.iter().map(node).collect();
    Graph { name: "", doc: "", cycle_hz: 100.0, budget_ms: None, tunable: false, root, nodes: nodes.leak() }
}
