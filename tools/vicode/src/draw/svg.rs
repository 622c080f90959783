//! SVG.

use std::fmt::Write;

use super::{Diagram, Edge, Node};
use crate::compare::Change;

/// Colours of a state machine, as in the drawings of trees.
const FILL: &str = "#fff3d6";
const BORDER: &str = "#bf8700";
const TEXT: &str = "#1f2328";
const GREY: &str = "#7d8590";
/// Attributes of small text with a white outline, which hides lines behind the letters.
const OUTLINED: &str = "font-size=\"10\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"";

/// Height of a line below the drawing, points.
const NOTE: f32 = 16.0;

/// Style of a part.
#[derive(Clone, Copy)]
struct Style {
    fill: &'static str,
    border: &'static str,
    text: &'static str,
    /// Further attributes of lines and borders.
    dashes: &'static str,
    thickness: f32,
}

const PLAIN: Style = Style { fill: FILL, border: BORDER, text: TEXT, dashes: "", thickness: 1.5 };
const EQUAL: Style = Style { fill: "#ffffff", border: "#b4bbc4", text: "#5c6570", ..PLAIN };

/// Returns the style of a mark. Names also have a sign, so that the colour is not the only difference.
const fn style(mark: Option<Change>, is_difference: bool) -> Style {
    match mark {
        None if is_difference => EQUAL,
        None => PLAIN,
        Some(Change::Added) => Style { fill: "#e3f6ea", border: "#137a48", text: "#0d5c36", thickness: 2.5, ..PLAIN },
        Some(Change::Removed) => Style {
            fill: "#fdeaea",
            border: "#c62828",
            text: "#a11f1f",
            dashes: "stroke-dasharray=\"2 4\"",
            thickness: 2.0,
        },
        Some(Change::Changed) => Style { fill: "#fff3d6", border: "#9a6700", text: "#7a5200", thickness: 2.5, ..PLAIN },
    }
}

/// Formats a diagram as SVG.
#[must_use]
pub fn svg(diagram: &Diagram) -> String {
    let longest = diagram.notes.iter().map(|note| note.chars().count()).max().unwrap_or(0);
    let width = diagram.width.max(longest as f32 * 7.3 + 32.0);
    let height = diagram.height + NOTE * (diagram.notes.len() + usize::from(diagram.is_difference) * 2) as f32;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" \
         height=\"{height:.0}\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" font-size=\"12\" \
         text-anchor=\"middle\">\n<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        escaped(&diagram.name)
    );
    let of = |mark| style(mark, diagram.is_difference);
    diagram.edges.iter().for_each(|edge| arrow(&mut out, edge, of(edge.mark), diagram.is_difference));
    diagram.nodes.iter().for_each(|node| state(&mut out, node, of(node.mark)));
    diagram.edges.iter().for_each(|edge| names(&mut out, edge, &of));
    if diagram.is_difference {
        legend(&mut out, diagram);
    }
    below(&mut out, diagram);
    out + "</svg>\n"
}

fn state(out: &mut String, node: &Node, style: Style) {
    let ((x, y), (width, height)) = (node.centre, node.size);
    let (left, top) = (x - width / 2.0, y - height / 2.0);
    let Style { fill, border, dashes, thickness, .. } = style;
    let thickness = if node.initial { thickness.max(3.0) } else { thickness };
    let frame = |out: &mut String, inset: f32| {
        let (x, y, width, height) = (left + inset, top + inset, width - 2.0 * inset, height - 2.0 * inset);
        writeln!(
            out,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"8\" fill=\"{fill}\" \
             stroke=\"{border}\" stroke-width=\"{thickness}\" {dashes}/>"
        )
    };
    frame(out, 0.0).unwrap_or_default();
    if node.last {
        frame(out, 4.0).unwrap_or_default();
    }
    let sign = node.mark.map_or_else(String::new, |mark| format!("{} ", mark.sign()));
    text(out, (x, top + 24.0), style.text, "font-weight=\"bold\"", &(sign + &node.title()));
    for (index, line) in node.lines().iter().enumerate() {
        text(out, (x, top + 40.0 + 14.0 * index as f32), style.text, "font-size=\"10\"", line);
    }
}

fn text(out: &mut String, (x, y): (f32, f32), colour: &str, attributes: &str, text: &str) {
    let text = escaped(text);
    writeln!(out, "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{colour}\" {attributes}>{text}</text>").unwrap_or_default();
}

fn arrow(out: &mut String, edge: &Edge, style: Style, is_difference: bool) {
    let Style { dashes, thickness, .. } = style;
    let colour = if is_difference { style.border } else { GREY };
    for line in [&edge.leader, &edge.points].into_iter().filter(|line| !line.is_empty()) {
        let points: Vec<String> = line.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        writeln!(
            out,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{thickness}\" \
             stroke-linejoin=\"round\" {dashes}/>",
            points.join(" ")
        )
        .unwrap_or_default();
    }
    if let Some([tip, left, right]) = edge.head() {
        writeln!(
            out,
            "<path d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}z\" fill=\"{colour}\"/>",
            tip.0, tip.1, left.0, left.1, right.0, right.1
        )
        .unwrap_or_default();
    }
}

fn names(out: &mut String, edge: &Edge, style: &impl Fn(Option<Change>) -> Style) {
    for (index, label) in edge.labels.iter().enumerate() {
        let y = edge.label_at.1 + 13.0 * (index as f32 - (edge.labels.len() as f32 - 1.0) / 2.0) + 4.0;
        text(out, (edge.label_at.0, y), style(label.mark).text, OUTLINED, &label.text);
    }
}

/// Draws the legend of the marks.
fn legend(out: &mut String, diagram: &Diagram) {
    let words = [
        (Some(Change::Added), "+ added"),
        (Some(Change::Removed), "- removed, dotted"),
        (Some(Change::Changed), "~ changed"),
        (None, "grey: equal"),
    ];
    for (index, (mark, word)) in words.into_iter().enumerate() {
        let at = (16.0 + 140.0 * index as f32, diagram.height);
        text(out, at, style(mark, true).text, "text-anchor=\"start\" font-weight=\"bold\"", word);
    }
}

/// Draws the lines below the diagram.
fn below(out: &mut String, diagram: &Diagram) {
    for (index, note) in diagram.notes.iter().enumerate() {
        // Lines without indentation are headings.
        let sign = note.strip_prefix(' ').filter(|_| diagram.is_difference);
        let mark = match sign.and_then(|note| note.trim_start().chars().next()) {
            Some('+') => Some(Change::Added),
            Some('-') => Some(Change::Removed),
            Some('~') => Some(Change::Changed),
            _ => None,
        };
        let at = (16.0, diagram.height + NOTE * (index + 1) as f32 + 4.0);
        let mono = "text-anchor=\"start\" font-family=\"'DejaVu Sans Mono', monospace\" xml:space=\"preserve\"";
        text(out, at, style(mark, true).text, mono, note);
    }
}

impl Edge {
    /// Returns the corners of the arrow head: its tip, and the two others.
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
