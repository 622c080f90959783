//! SVG.

use std::fmt::Write;

use super::{Diagram, Edge, Node};

/// Colours of a state machine, as in the drawings of trees.
const FILL: &str = "#fff3d6";
const BORDER: &str = "#bf8700";
const TEXT: &str = "#1f2328";
const GREY: &str = "#7d8590";
/// Small text that lines do not shine through.
const OUTLINED: &str = "font-size=\"10\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"";

/// A drawing as SVG.
#[must_use]
pub fn svg(diagram: &Diagram) -> String {
    let Diagram { width, height, .. } = diagram;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" \
         height=\"{height:.0}\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" font-size=\"12\" \
         text-anchor=\"middle\">\n<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        escaped(&diagram.name)
    );
    diagram.edges.iter().for_each(|edge| arrow(&mut out, edge));
    diagram.nodes.iter().for_each(|node| state(&mut out, node));
    diagram.edges.iter().for_each(|edge| names(&mut out, edge));
    out + "</svg>\n"
}

fn state(out: &mut String, node: &Node) {
    let ((x, y), (width, height)) = (node.centre, node.size);
    let (left, top) = (x - width / 2.0, y - height / 2.0);
    let thickness = if node.initial { 3.0 } else { 1.5 };
    let frame = |out: &mut String, inset: f32| {
        let (x, y, width, height) = (left + inset, top + inset, width - 2.0 * inset, height - 2.0 * inset);
        writeln!(
            out,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"8\" fill=\"{FILL}\" \
             stroke=\"{BORDER}\" stroke-width=\"{thickness}\"/>"
        )
    };
    frame(out, 0.0).unwrap_or_default();
    if node.last {
        frame(out, 4.0).unwrap_or_default();
    }
    text(out, (x, top + 24.0), "font-weight=\"bold\"", &node.name);
    for (index, line) in node.lines().iter().enumerate() {
        text(out, (x, top + 40.0 + 14.0 * index as f32), "font-size=\"10\"", line);
    }
}

fn text(out: &mut String, (x, y): (f32, f32), attributes: &str, text: &str) {
    let text = escaped(text);
    writeln!(out, "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{TEXT}\" {attributes}>{text}</text>").unwrap_or_default();
}

fn arrow(out: &mut String, edge: &Edge) {
    let points: Vec<String> = edge.points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    writeln!(out, "<polyline points=\"{}\" fill=\"none\" stroke=\"{GREY}\" stroke-width=\"1.5\"/>", points.join(" "))
        .unwrap_or_default();
    if let Some([tip, left, right]) = edge.head() {
        writeln!(
            out,
            "<path d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}z\" fill=\"{GREY}\"/>",
            tip.0, tip.1, left.0, left.1, right.0, right.1
        )
        .unwrap_or_default();
    }
}

fn names(out: &mut String, edge: &Edge) {
    for (index, label) in edge.labels.iter().enumerate() {
        let y = edge.label_at.1 + 13.0 * (index as f32 - (edge.labels.len() as f32 - 1.0) / 2.0) + 4.0;
        text(out, (edge.label_at.0, y), OUTLINED, label);
    }
}

impl Edge {
    /// The corners of the arrow head: its tip, and the two others.
    #[must_use]
    pub fn head(&self) -> Option<[(f32, f32); 3]> {
        let [.., before, tip] = self.points[..] else { return None };
        let (dx, dy) = (tip.0 - before.0, tip.1 - before.1);
        let length = dx.hypot(dy).max(0.001);
        let (dx, dy) = (9.0 * dx / length, 9.0 * dy / length);
        Some([tip, (tip.0 - dx - dy * 0.45, tip.1 - dy + dx * 0.45), (tip.0 - dx + dy * 0.45, tip.1 - dy - dx * 0.45)])
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
