//! What is drawn, in points.

use super::automatic;
use super::route::{course, place_names};
use crate::compare::{Change, Marks};
use crate::files::Layout;
use crate::model::{self, Component, Graph, Link, LinkKind, own_links};

/// Width and least height of a state, points.
const WIDTH: f32 = 160.0;
const HEIGHT: f32 = 40.0;
/// Height of a line of text, points.
const LINE: f32 = 14.0;
/// White around all, points.
const MARGIN: f32 = 50.0;

/// State that is left, `None` for all, and state that is entered.
type Pair = (Option<usize>, usize);

/// A machine with the places of all its parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagram {
    /// Name of the component.
    pub name: String,
    /// Width, points.
    pub width: f32,
    /// Height, points.
    pub height: f32,
    /// States.
    pub nodes: Vec<Node>,
    /// Transitions; those between the same states are one.
    pub edges: Vec<Edge>,
    /// Whether it shows the difference of two versions: what has no mark is equal.
    pub is_difference: bool,
    /// Lines below the drawing.
    pub notes: Vec<String>,
}

/// A state.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Its name.
    pub name: String,
    /// Whether the machine starts in it.
    pub initial: bool,
    /// Whether no transition leaves it.
    pub last: bool,
    /// Centre and size, points.
    pub centre: (f32, f32),
    /// Width and height, points.
    pub size: (f32, f32),
    /// Its hooks.
    pub hooks: Vec<String>,
    /// Its children and those of its hooks. Those of the transitions that leave it belong to the transitions here.
    pub links: Vec<Link>,
    /// How it differs, in a difference.
    pub mark: Option<Change>,
}

/// Transitions from one state to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Names and timers, one line each.
    pub labels: Vec<Label>,
    /// The curve, points.
    pub points: Vec<(f32, f32)>,
    /// Middle of the labels, points.
    pub label_at: (f32, f32),
}

/// Name and timer of a transition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Text; with a mark it begins with the sign of the mark.
    pub text: String,
    /// How it differs, in a difference.
    pub mark: Option<Change>,
}

impl Diagram {
    /// A component as it is arranged, states without a position automatically.
    #[must_use]
    pub fn of(component: &Component, layout: &Layout) -> Self {
        let notes = layout.notes(&component.key).flat_map(|note| note.text.lines()).map(str::to_owned).collect();
        Self { notes, ..Self::marked(component, layout, &Marks::default()) }
    }

    /// The difference of two versions of a machine; `notes` are lines below it.
    #[must_use]
    pub fn of_difference(both: &Component, layout: &Layout, marks: &Marks, notes: &str) -> Self {
        let notes = notes.lines().map(str::to_owned).collect();
        Self { is_difference: true, notes, ..Self::marked(both, layout, marks) }
    }

    fn marked(component: &Component, layout: &Layout, marks: &Marks) -> Self {
        let positions = automatic(component, layout);
        let mut nodes: Vec<Node> = Vec::new();
        for (index, (state, at)) in component.states.iter().zip(positions).enumerate() {
            let name = state.function.name.text.clone();
            let (hooks, links) = (hooks_of(component, &name), own_links(component, index));
            let size = (WIDTH, height(component, index));
            let centre = (at.x as f32, at.y as f32);
            let mark = marks.states.get(&name).copied();
            nodes.push(Node { name, initial: state.initial, last: state.last, centre, size, hooks, links, mark });
        }
        let mut diagram = Self { name: component.name.text.clone(), nodes, ..Self::default() };
        diagram.connect(&Graph::of(component), marks);
        diagram.frame();
        diagram
    }

    fn connect(&mut self, graph: &Graph, marks: &Marks) {
        let mut pairs: Vec<(Pair, Vec<Label>)> = Vec::new();
        let mut add = |pair, label: Label| match pairs.iter_mut().find(|(known, _)| *known == pair) {
            Some((_, labels)) if labels.contains(&label) => {}
            Some((_, labels)) => labels.push(label),
            None => pairs.push((pair, vec![label])),
        };
        for edge in &graph.edges {
            let from = if edge.from_any { "*" } else { &self.nodes[edge.from].name };
            let label = Label::new(edge, marks.arrow(&edge.name, from, &self.nodes[edge.to].name));
            add(((!edge.from_any).then_some(edge.from), edge.to), label);
        }
        self.edges = pairs.into_iter().map(|((from, to), labels)| self.edge(from, to, labels)).collect();
        place_names(&mut self.edges, &self.nodes);
    }

    fn edge(&self, from: Option<usize>, to: usize, mut labels: Vec<Label>) -> Edge {
        let end = &self.nodes[to];
        let Some(from) = from.map(|from| &self.nodes[from]) else {
            // From all states: a short arrow from above.
            let top = (end.centre.0 + 40.0, end.centre.1 - end.size.1 / 2.0);
            let points = vec![(top.0, top.1 - 34.0), top];
            for label in &mut labels {
                label.text.insert_str(0, "* ");
            }
            return Edge { label_at: (top.0, top.1 - 36.0 - LINE * labels.len() as f32 / 2.0), labels, points };
        };
        if std::ptr::eq(from, end) {
            let (x, y) = (end.centre.0 + end.size.0 / 2.0, end.centre.1);
            let points = vec![(x, y - 10.0), (x + 24.0, y - 16.0), (x + 24.0, y + 16.0), (x, y + 10.0)];
            return Edge { labels, points, label_at: (x + 60.0, y) };
        }
        let points = course(from, end, &self.nodes);
        Edge { label_at: points[points.len() / 2], labels, points }
    }

    /// Moves all so that nothing lies outside, and measures it.
    fn frame(&mut self) {
        let corners = |node: &Node| {
            let ((x, y), (width, height)) = (node.centre, node.size);
            [(x - width / 2.0, y - height / 2.0), (x + width / 2.0, y + height / 2.0)]
        };
        let of_edge = |edge: &Edge| [&edge.points[..], &[(edge.label_at.0, edge.label_at.1 - LINE)]].concat();
        let points = self.nodes.iter().flat_map(corners).chain(self.edges.iter().flat_map(of_edge));
        let mut bounds: Option<[f32; 4]> = None;
        for (x, y) in points {
            let [left, top, right, bottom] = bounds.unwrap_or([x, y, x, y]);
            bounds = Some([left.min(x), top.min(y), right.max(x), bottom.max(y)]);
        }
        let [left, top, right, bottom] = bounds.unwrap_or([0.0, 0.0, WIDTH, HEIGHT]);
        let (x, y) = (MARGIN - left, MARGIN - top);
        for node in &mut self.nodes {
            node.centre = (node.centre.0 + x, node.centre.1 + y);
        }
        for edge in &mut self.edges {
            edge.points.iter_mut().for_each(|point| *point = (point.0 + x, point.1 + y));
            edge.label_at = (edge.label_at.0 + x, edge.label_at.1 + y);
        }
        (self.width, self.height) = (right - left + 2.0 * MARGIN, bottom - top + 2.0 * MARGIN);
    }
}

/// Height of a state, points.
pub(super) fn height(component: &Component, state: usize) -> f32 {
    let name = &component.states[state].function.name.text;
    HEIGHT + LINE * (hooks_of(component, name).len() + own_links(component, state).len()) as f32
}

/// The hooks of a state: `entry / greet`.
fn hooks_of(component: &Component, state: &str) -> Vec<String> {
    let hooks = component.hooks.iter().filter(|hook| hook.states.iter().any(|one| one.text == state));
    hooks.map(|hook| format!("{} / {}", hook.role.word(), hook.function.name.text)).collect()
}

impl Label {
    fn new(edge: &model::Edge, mark: Option<Change>) -> Self {
        let timer = edge.after_ms.map_or_else(String::new, |ms| format!(" after {ms} ms"));
        let sign = mark.map_or_else(String::new, |mark| format!("{} ", mark.sign()));
        Self { text: format!("{sign}{}{timer}", edge.name), mark }
    }
}

impl Edge {
    /// How it differs: as all its transitions do, else it is equal.
    #[must_use]
    pub fn mark(&self) -> Option<Change> {
        let first = self.labels.first()?.mark;
        first.filter(|_| self.labels.iter().all(|label| label.mark == first))
    }
}

impl Node {
    /// The lines below the name: hooks, then children; `<` is a requirement, `>` a modulation.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        let mark = |kind| if kind == LinkKind::Requirement { '<' } else { '>' };
        let links = self.links.iter().map(|link| format!("{} {}", mark(link.kind), link.child));
        self.hooks.iter().cloned().chain(links).collect()
    }
}
