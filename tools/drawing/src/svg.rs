//! Activation trees as SVG: the root at the top, inputs and outputs at the bottom.
//!
//! A box has the colour of the kind of its component. Requirement links are dashed, modulation links are solid; a query, for an age or
//! an outcome, is dotted and ends with a ring. Text outside the boxes is grey, so that it can be read on white and on black.

use std::fmt::Write;

use bica_wire::model::{Component, Description, LinkKind};

use crate::layout::{Kind, Point, Rectangle, Tree, add_queries, links, path};

#[cfg(test)]
pub(crate) mod tests;

const GREY: &str = "#7d8590";
const LEGEND_HEIGHT: f64 = 44.0;
/// Attributes of the line of a query.
const DOTTED: &str = " stroke-dasharray=\"1.5 3\" stroke-linecap=\"round\"";

/// Usual width of a drawing, margin around it, and size of a box, px.
const WIDTH: f64 = 900.0;
const MARGIN: f64 = 14.0;
const BOX_WIDTH: f64 = 104.0;
const BOX_HEIGHT: f64 = 38.0;
/// A height that leaves each corridor all the room it may have, px.
const HIGH: f64 = 1e6;

/// Returns a drawing of a tree as SVG, about 900 pixels wide for two dozen components.
#[must_use]
pub fn svg(tree: &Description) -> String {
    let drawn = laid_out(tree);
    let (width, height) = (drawn.width, drawn.height + LEGEND_HEIGHT);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" \
         height=\"{height:.0}\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" font-size=\"12\" \
         text-anchor=\"middle\">\n<title>{}</title>\n",
        escaped(&tree.name)
    );
    let mut lines = drawn.lines.iter();
    for (link, points) in tree.components.iter().flat_map(|component| &component.links).zip(lines.by_ref()) {
        out += &line(link.kind, points, link.to, &drawn);
    }
    for ((_, of, word), points) in queries(tree).zip(lines) {
        out += &query(word, points, of, &drawn);
    }
    for (item, node) in tree.components.iter().enumerate() {
        out += &component(tree, node, &drawn.boxes[item], (Kind::of(tree, item), item == tree.root));
    }
    out += &legend(tree, width, drawn.height);
    out + "</svg>\n"
}

/// Places of all boxes and courses of all links.
fn laid_out(tree: &Description) -> Tree {
    let widths = vec![BOX_WIDTH; tree.components.len()];
    let mut all = links(tree);
    add_queries(&mut all, queries(tree).map(|(from, of, _)| (from, of)));
    Tree::new(&all, &widths, (WIDTH, HIGH), (BOX_HEIGHT, BOX_HEIGHT)).cropped(MARGIN)
}

/// The queries of all components: who asks, who is asked, and for what.
fn queries(tree: &Description) -> impl Iterator<Item = (usize, usize, &'static str)> {
    let of = |(from, node): (usize, &Component)| {
        node.queries.iter().map(|query| (from, query.of, query.kind.word())).collect::<Vec<_>>()
    };
    tree.components.iter().enumerate().flat_map(of)
}

/// Box with the component's name, its rate, and the number of components that write it in one cycle.
fn component(tree: &Description, node: &Component, place: &Rectangle, (kind, root): (Kind, bool)) -> String {
    let (x, y) = (place.x, place.y - place.height / 2.0);
    let (fill, border) = kind.colours();
    let (left, thickness) = (x - BOX_WIDTH / 2.0, if root { 3.0 } else { 1.5 });
    let mut rate = node.hz.map_or("every cycle".into(), |hz| format!("{hz} Hz"));
    let mut doc = node.doc.trim().to_owned();
    if let Some(written) = tree.written(node) {
        write!(rate, " · {} writers", node.writers.len()).expect("a string grows");
        doc = format!("{doc}\n{written}");
    }
    format!(
        "<g><title>{}</title><rect x=\"{left:.1}\" y=\"{y:.1}\" width=\"{BOX_WIDTH}\" height=\"{BOX_HEIGHT}\" rx=\"7\" \
         fill=\"{fill}\" stroke=\"{border}\" stroke-width=\"{thickness}\"/>\
         <text x=\"{x:.1}\" y=\"{:.1}\" fill=\"#1f2328\"{}>{}</text>\
         <text x=\"{x:.1}\" y=\"{:.1}\" fill=\"#424a53\" font-size=\"10\"{}>{}</text></g>\n",
        escaped(doc.trim()),
        y + 17.0,
        fitting(&node.name, 14),
        escaped(&node.name),
        y + 31.0,
        fitting(&rate, 20),
        escaped(&rate),
    )
}

/// Attributes that compress a text with more characters than fit into its box to the width of the box.
fn fitting(name: &str, most: usize) -> String {
    if name.chars().count() > most {
        format!(" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"", BOX_WIDTH - 10.0)
    } else {
        String::new()
    }
}

/// The line of a link, with an arrow head at the box to which it leads.
fn line(kind: LinkKind, points: &[Point], to: usize, drawn: &Tree) -> String {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return String::new() };
    let dash = if kind == LinkKind::Requirement { " stroke-dasharray=\"5 3\"" } else { "" };
    let line = format!("<path d=\"{}\" fill=\"none\" stroke=\"{GREY}\" stroke-width=\"1.3\"{dash}/>\n", path(points));
    line + &if drawn.boxes[to].y < first.1 { head(first.0, first.1, 1.0) } else { head(last.0, last.1, -1.0) }
}

/// The line of a query, with a ring at the component that is asked and its word in a tooltip.
fn query(word: &str, points: &[Point], of: usize, drawn: &Tree) -> String {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return String::new() };
    let (at, side) = if drawn.boxes[of].y < first.1 { (first, 1.0) } else { (last, -1.0) };
    format!(
        "<g fill=\"none\" stroke=\"{GREY}\"><title>{word}</title><path d=\"{}\" stroke-width=\"1.5\"{DOTTED}/>\
         <circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"3.5\" stroke-width=\"1.3\"/></g>\n",
        path(points),
        at.0,
        at.1 + 3.5 * side
    )
}

/// Arrow head at a box above (`side` 1) or below (`side` -1).
fn head(x: f64, y: f64, side: f64) -> String {
    let back = 7.0 * side;
    format!("<path d=\"M{x:.1} {y:.1}l-3.5 {back:.1}h7z\" fill=\"{GREY}\"/>\n")
}

fn legend(tree: &Description, width: f64, top: f64) -> String {
    let y = top + 20.0;
    let kinds =
        Kind::ALL.into_iter().filter(|&kind| (0..tree.components.len()).any(|node| Kind::of(tree, node) == kind));
    let mut entries: Vec<(String, &str)> = kinds.map(|kind| (swatch(kind), kind.name())).collect();
    entries.push((sample(" stroke-dasharray=\"5 3\""), "reads (requirement)"));
    entries.push((sample(""), "writes (modulation)"));
    if queries(tree).next().is_some() {
        entries.push((sample(DOTTED), "asks for an age or outcome"));
    }
    let length = |name: &str| 42.0 + 6.3 * name.len() as f64;
    let whole: f64 = entries.iter().map(|(_, name)| length(name)).sum();
    let mut x = (width - whole) / 2.0;
    let mut out = format!("<g fill=\"{GREY}\" font-size=\"11\" text-anchor=\"start\">\n");
    for (mark, name) in entries {
        writeln!(out, "<g transform=\"translate({x:.1} {y:.1})\">{mark}<text x=\"26\" y=\"4\">{name}</text></g>")
            .expect("a string grows");
        x += length(name);
    }
    out + "</g>\n"
}

fn swatch(kind: Kind) -> String {
    let (fill, border) = kind.colours();
    format!(
        "<rect y=\"-6\" width=\"20\" height=\"12\" rx=\"3\" fill=\"{fill}\" stroke=\"{border}\" stroke-width=\"1.5\"/>"
    )
}

fn sample(dash: &str) -> String {
    format!("<path d=\"M0 0h20\" stroke=\"{GREY}\" stroke-width=\"1.5\"{dash}/>")
}

/// Escapes text for XML; characters that XML does not allow become spaces.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => out.push(' '),
            control if control.is_control() => out.push(' '),
            other => out.push(other),
        }
    }
    out
}
