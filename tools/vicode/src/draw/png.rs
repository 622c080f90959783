//! PNG.

use bica_drawing::canvas::{Area, Canvas, Ink};
use bica_drawing::text::Font;
use glam::Vec2;

use super::{Diagram, Edge, Node};

const PAPER: [u8; 3] = [255, 255, 255];
const FILL: [u8; 3] = [255, 243, 214];
const BORDER: [u8; 3] = [191, 135, 0];
const TEXT: [u8; 3] = [31, 35, 40];
const GREY: [u8; 3] = [125, 133, 144];
/// Height of a line below the drawing, points.
const NOTE: f32 = 16.0;

/// Draws a diagram as a picture.
#[must_use]
pub fn png(diagram: &Diagram) -> Canvas {
    let longest = diagram.notes.iter().map(|note| Font::Small.width(note) + 2.0 * NOTE).fold(diagram.width, f32::max);
    let height = diagram.height + NOTE * diagram.notes.len() as f32;
    let mut canvas = Canvas::new(longest.ceil() as usize, height.ceil() as usize, PAPER);
    diagram.edges.iter().for_each(|edge| arrow(&mut canvas, edge));
    diagram.nodes.iter().for_each(|node| state(&mut canvas, node));
    diagram.edges.iter().for_each(|edge| names(&mut canvas, edge));
    for (index, note) in diagram.notes.iter().enumerate() {
        canvas.write(Vec2::new(NOTE, diagram.height + NOTE * index as f32), Font::Small, TEXT, note);
    }
    canvas
}

fn state(canvas: &mut Canvas, node: &Node) {
    let ((x, y), (width, height)) = (node.centre, node.size);
    let top = y - height / 2.0;
    let area = Area::sized(x - width / 2.0, top, width, height);
    canvas.rounded_rectangle(area, 8.0, FILL);
    canvas.outline(area, 8.0, if node.initial { 3.0 } else { 1.5 }, BORDER);
    if node.last {
        canvas.outline(Area::sized(area.from.x + 4.0, top + 4.0, width - 8.0, height - 8.0), 6.0, 1.5, BORDER);
    }
    canvas.write_centred(Vec2::new(x, top + 20.0), Font::Bold, TEXT, &node.name);
    for (index, line) in node.lines().iter().enumerate() {
        canvas.write_centred(Vec2::new(x, top + 36.0 + 14.0 * index as f32), Font::Small, TEXT, line);
    }
}

fn arrow(canvas: &mut Canvas, edge: &Edge) {
    for line in [&edge.leader, &edge.points] {
        let points: Vec<Vec2> = line.iter().map(|(x, y)| Vec2::new(*x, *y)).collect();
        canvas.polyline(&points, 1.5, GREY);
    }
    if let Some([tip, left, right]) = edge.head() {
        canvas.polygon(&[Vec2::from(tip), Vec2::from(left), Vec2::from(right)], GREY);
    }
}

fn names(canvas: &mut Canvas, edge: &Edge) {
    for (index, label) in edge.labels.iter().enumerate() {
        let y = edge.label_at.1 + 13.0 * (index as f32 - (edge.labels.len() as f32 - 1.0) / 2.0);
        let half = Font::Small.width(&label.text) / 2.0;
        let behind = Area::sized(edge.label_at.0 - half - 2.0, y - 6.0, 2.0 * half + 4.0, 12.0);
        canvas.rounded_rectangle(behind, 2.0, Ink { rgb: PAPER, alpha: 0.8 });
        canvas.write_centred(Vec2::new(edge.label_at.0, y), Font::Small, TEXT, &label.text);
    }
}
