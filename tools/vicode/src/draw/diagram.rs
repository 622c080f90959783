//! Drawing of a machine, in points.

use bica_syntax::component::model::{self, Machine, MachineState};

use super::automatic::{arranged, arrows, automatic};
use super::parts::{Edge, HEIGHT, LINE, Label, Node, WIDTH, height, hooks_of};
use super::route::{course, place_names};
use crate::compare::Marks;
use crate::files::Layout;
use crate::model::{Component, Function, State, links};

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
        let machine = component.machine();
        let node = |(index, (state, parts)): (usize, (&State, &MachineState<&Function>))| {
            let name = state.function.name.text.clone();
            let (hooks, links) = (hooks_of(component, &name), links(Some(index), parts.functions().copied()));
            let mut asks: Vec<String> = parts.functions().flat_map(|function| function.asks()).collect();
            asks.sort();
            asks.dedup();
            let lines = hooks.len() + links.len() + asks.len();
            let (size, mark) = ((WIDTH, height(lines)), marks.states.get(&name).copied());
            let takes = component.takes(&name).map(str::to_owned);
            let (initial, last, end, centre) = (state.initial, state.last, state.end, (0.0, 0.0));
            Node { name, initial, last, centre, size, takes, end, hooks, links, asks, mark }
        };
        let nodes = component.states.iter().zip(&machine.states).enumerate().map(node).collect();
        let mut diagram = Self { name: component.name.text.clone(), nodes, ..Self::default() };
        if component.states.iter().any(|state| layout.get(&component.key, &state.function.name.text).is_some()) {
            for (node, at) in diagram.nodes.iter_mut().zip(automatic(component, layout)) {
                node.centre = (at.x as f32, at.y as f32);
            }
            diagram.connect(&machine, marks);
        } else {
            diagram.arrange(component, &machine, marks);
        }
        diagram.frame();
        diagram
    }

    /// Takes places and lines of the automatic layout.
    fn arrange(&mut self, component: &Component, machine: &Machine<&Function>, marks: &Marks) {
        let arrows = arrows(machine);
        let labels: Vec<Label> = arrows.iter().map(|edge| self.label(edge, marks)).collect();
        let drawn = arranged(component, machine, &arrows, labels.iter().map(|label| &*label.text));
        let points = |line: &[(f64, f64)]| line.iter().map(|(x, y)| (*x as f32, *y as f32)).collect();
        for (node, place) in self.nodes.iter_mut().zip(&drawn.boxes) {
            node.centre = (place.x as f32, place.y as f32);
        }
        for (index, (label, course)) in labels.into_iter().zip(drawn.courses).enumerate() {
            self.edges.push(Edge {
                mark: label.mark,
                points: points(&course.points),
                leader: points(&course.leader),
                label_at: (course.label.0 as f32, course.label.1 as f32),
                labels: if course.owner == index { vec![label] } else { Vec::new() },
            });
        }
    }

    /// Name and timer of an edge; one from all states begins with `*`.
    fn label(&self, edge: &model::Edge<&Function>, marks: &Marks) -> Label {
        let from = if edge.any { "*" } else { &self.nodes[edge.from].name };
        let mut label = Label::new(edge, marks.arrow(&edge.name(), from, &self.nodes[edge.to].name));
        if edge.any {
            label.text.insert_str(0, "* ");
        }
        label
    }

    /// Draws curves between states that a person has placed.
    fn connect(&mut self, machine: &Machine<&Function>, marks: &Marks) {
        let mut pairs: Vec<(Pair, Vec<Label>)> = Vec::new();
        for edge in arrows(machine) {
            let (pair, label) = (((!edge.any).then_some(edge.from), edge.to), self.label(edge, marks));
            match pairs.iter_mut().find(|(known, _)| *known == pair) {
                Some((_, labels)) => labels.push(label),
                None => pairs.push((pair, vec![label])),
            }
        }
        self.edges = pairs.into_iter().map(|((from, to), labels)| self.edge(from, to, labels)).collect();
        place_names(&mut self.edges, &self.nodes);
    }

    fn edge(&self, from: Option<usize>, to: usize, labels: Vec<Label>) -> Edge {
        let end = &self.nodes[to];
        let mark = labels.first().and_then(|first| first.mark);
        let mark = mark.filter(|_| labels.iter().all(|label| label.mark == mark));
        let edge = |points, label_at| Edge { mark, leader: Vec::new(), points, label_at, labels: Vec::new() };
        let edge = match from.map(|from| &self.nodes[from]) {
            None => {
                // From all states: a short arrow from above.
                let top = (end.centre.0 + 40.0, end.centre.1 - end.size.1 / 2.0);
                edge(vec![(top.0, top.1 - 34.0), top], (top.0, top.1 - 36.0 - LINE * labels.len() as f32 / 2.0))
            }
            Some(from) if std::ptr::eq(from, end) => {
                let (x, y) = (end.centre.0 + end.size.0 / 2.0, end.centre.1);
                let points = vec![(x, y - 10.0), (x + 24.0, y - 16.0), (x + 24.0, y + 16.0), (x, y + 10.0)];
                edge(points, (x + 60.0, y))
            }
            Some(from) => {
                let points = course(from, end, &self.nodes);
                let middle = points[points.len() / 2];
                edge(points, middle)
            }
        };
        Edge { labels, ..edge }
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
            let points = edge.points.iter_mut().chain(&mut edge.leader);
            points.for_each(|point| *point = (point.0 + x, point.1 + y));
            edge.label_at = (edge.label_at.0 + x, edge.label_at.1 + y);
        }
        (self.width, self.height) = (right - left + 2.0 * MARGIN, bottom - top + 2.0 * MARGIN);
    }
}
