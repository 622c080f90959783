//! Drawing of a machine, in points.

use bica_syntax::component::model::Machine;

use super::automatic;
use super::parts::{Edge, HEIGHT, LINE, Label, Node, WIDTH, height, hooks_of};
use super::route::{course, place_names};
use crate::compare::Marks;
use crate::files::Layout;
use crate::model::{Component, Function, links};

/// Margin around the drawing, points.
const MARGIN: f32 = 50.0;

/// State that is left (`None`: all states), and state that is entered.
type Pair = (Option<usize>, usize);

/// A machine with the coordinates of all its parts.
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
    /// Transitions; those between the same states share one edge.
    pub edges: Vec<Edge>,
    /// Whether it shows the difference of two versions, in which parts without a mark are equal.
    pub is_difference: bool,
    /// Lines below the drawing.
    pub notes: Vec<String>,
}

impl Diagram {
    /// Draws a component with the positions of `layout`, and automatic ones for the other states.
    #[must_use]
    pub fn of(component: &Component, layout: &Layout) -> Self {
        let notes = layout.notes(&component.key).flat_map(|note| note.text.lines()).map(str::to_owned).collect();
        Self { notes, ..Self::marked(component, layout, &Marks::default()) }
    }

    /// Draws the difference of two versions of a machine; `notes` are lines below it.
    #[must_use]
    pub fn of_difference(both: &Component, layout: &Layout, marks: &Marks, notes: &str) -> Self {
        let notes = notes.lines().map(str::to_owned).collect();
        Self { is_difference: true, notes, ..Self::marked(both, layout, marks) }
    }

    fn marked(component: &Component, layout: &Layout, marks: &Marks) -> Self {
        let positions = automatic(component, layout);
        let mut nodes: Vec<Node> = Vec::new();
        let machine = component.machine();
        for (index, (state, at)) in component.states.iter().zip(positions).enumerate() {
            let name = state.function.name.text.clone();
            let links = links(Some(index), machine.states[index].functions().copied());
            let hooks = hooks_of(component, &name);
            let takes = component.takes(&name).map(str::to_owned);
            let size = (WIDTH, height(hooks.len() + links.len()));
            let centre = (at.x as f32, at.y as f32);
            let mark = marks.states.get(&name).copied();
            let (initial, last, end) = (state.initial, state.last, state.end);
            nodes.push(Node { name, initial, last, centre, size, takes, end, hooks, links, mark });
        }
        let mut diagram = Self { name: component.name.text.clone(), nodes, ..Self::default() };
        diagram.connect(&machine, marks);
        diagram.frame();
        diagram
    }

    fn connect(&mut self, machine: &Machine<&Function>, marks: &Marks) {
        let mut pairs: Vec<(Pair, Vec<Label>)> = Vec::new();
        let mut add = |pair, label: Label| match pairs.iter_mut().find(|(known, _)| *known == pair) {
            Some((_, labels)) if labels.contains(&label) => {}
            Some((_, labels)) => labels.push(label),
            None => pairs.push((pair, vec![label])),
        };
        for edge in &machine.edges {
            let from = if edge.any { "*" } else { &self.nodes[edge.from].name };
            let label = Label::new(edge, marks.arrow(&edge.name(), from, &self.nodes[edge.to].name));
            add(((!edge.any).then_some(edge.from), edge.to), label);
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

    /// Moves all parts so that they lie inside the drawing, and sets its size.
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
