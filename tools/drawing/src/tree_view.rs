//! Picture of an activation tree in one cycle: active components with their states, latent ones as pale boxes.

use bica_wire::model::{Description, LinkKind};
use glam::Vec2;

use super::canvas::{Area, Canvas, Rgb};
use super::palette::{FAINT, GHOST, MODULATED, PAPER, REQUIRED, TEXT, hex};
use super::text::Font;
use super::tree_state::TreeState;
use crate::layout::{Kind, Point, Tree, links};

/// Size of a component, px.
const BOX: Vec2 = Vec2::new(104.0, 38.0);

/// Drawing of the states of one tree; each component has the same position in every picture.
#[derive(Debug)]
pub struct TreeView {
    drawn: Tree,
    size: Vec2,
}

impl TreeView {
    /// A view of a tree for pictures of `width` × `height` px.
    #[must_use]
    pub fn new(tree: &Description, width: usize, height: usize) -> Self {
        let (size, height) = (Vec2::new(width as f32, height as f32), f64::from(BOX.y));
        let widths = vec![f64::from(BOX.x); tree.components.len()];
        let panel = (f64::from(size.x), f64::from(size.y));
        Self { drawn: Tree::new(&links(tree), &widths, panel, (height, height)), size }
    }

    /// Draws the tree in a state.
    #[must_use]
    pub fn draw(&self, tree: &TreeState<'_>) -> Canvas {
        let mut canvas = Canvas::new(self.size.x as usize, self.size.y as usize, PAPER);
        let components = tree.tree.components.iter().enumerate();
        let links = components.flat_map(|(from, node)| node.links.iter().map(move |link| (from, link)));
        for ((from, link), points) in links.zip(&self.drawn.lines) {
            if tree.uses(from, link) {
                line(&mut canvas, link.kind, points);
            }
        }
        for node in 0..tree.tree.components.len() {
            self.component(&mut canvas, tree, node);
        }
        canvas
    }

    fn component(&self, canvas: &mut Canvas, tree: &TreeState<'_>, node: usize) {
        let place = &self.drawn.boxes[node];
        let from = Vec2::new(place.x as f32, place.y as f32) - 0.5 * BOX;
        let area = Area { from, to: from + BOX };
        let (name, middle, line) = (&*tree.tree.components[node].name, area.centre(), Vec2::new(0.0, 8.0));
        if !tree.is_active(node) {
            canvas.rounded_rectangle(area, 6.0, PAPER);
            canvas.outline(area, 6.0, 1.0, GHOST);
            return canvas.write_centred(middle, Font::Normal, FAINT, name);
        }
        let (fill, border) = colours(tree.tree, node);
        canvas.rounded_rectangle(area, 6.0, fill);
        canvas.outline(area, 6.0, 1.8, border);
        match tree.state(node) {
            Some(state) => {
                canvas.write_centred(middle - line, Font::Bold, TEXT, name);
                canvas.write_centred(middle + line, Font::Small, TEXT, state);
            }
            None => canvas.write_centred(middle, Font::Bold, TEXT, name),
        }
    }
}

/// Draws the line of a link, with an arrow head where what is read or written arrives.
fn line(canvas: &mut Canvas, kind: LinkKind, points: &[Point]) {
    let points: Vec<Vec2> = points.iter().map(|(x, y)| Vec2::new(*x as f32, *y as f32)).collect();
    let rgb = if kind == LinkKind::Requirement { REQUIRED } else { MODULATED };
    canvas.polyline(&points, 1.6, rgb);
    match kind {
        LinkKind::Requirement => points.first().map(|at| canvas.arrow_head(*at, Vec2::NEG_Y, 8.0, rgb)),
        LinkKind::Modulation => points.last().map(|at| canvas.arrow_head(*at, Vec2::Y, 8.0, rgb)),
    };
}

fn colours(tree: &Description, node: usize) -> (Rgb, Rgb) {
    let (fill, border) = Kind::of(tree, node).colours();
    (hex(fill), hex(border))
}

/// Draws a legend of the tree in one line from `at`.
pub fn legend(canvas: &mut Canvas, at: Vec2) {
    let mut x = at.x;
    for kind in Kind::ALL {
        let (fill, border) = kind.colours();
        canvas.rounded_rectangle(Area::sized(x, at.y, 26.0, 12.0), 4.0, hex(fill));
        canvas.outline(Area::sized(x, at.y, 26.0, 12.0), 4.0, 1.5, hex(border));
        canvas.write(Vec2::new(x + 32.0, at.y), Font::Normal, TEXT, kind.name());
        x += 56.0 + Font::Normal.width(kind.name());
    }
    canvas.outline(Area::sized(x, at.y, 26.0, 12.0), 4.0, 1.0, GHOST);
    canvas.write(Vec2::new(x + 32.0, at.y), Font::Normal, FAINT, "latent");
    x += 56.0 + Font::Normal.width("latent");
    for (rgb, reads, words) in [(REQUIRED, true, "reads (requirement)"), (MODULATED, false, "writes (modulation)")] {
        let (from, to) = (Vec2::new(x, at.y + 6.0), Vec2::new(x + 26.0, at.y + 6.0));
        canvas.line(from, to, 1.6, rgb);
        canvas.arrow_head(if reads { from } else { to }, if reads { Vec2::NEG_X } else { Vec2::X }, 8.0, rgb);
        canvas.write(Vec2::new(x + 32.0, at.y), Font::Normal, TEXT, words);
        x += 56.0 + Font::Normal.width(words);
    }
}
