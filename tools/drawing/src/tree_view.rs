//! Picture of an activation tree in one cycle: active components with their states, latent ones as pale boxes.

use bica_wire::model::{Description, LinkKind};
use glam::Vec2;

use super::canvas::{Area, Canvas, Rgb};
use super::palette::{FAINT, GHOST, MODULATED, PAPER, REQUIRED, TEXT, hex};
use super::text::Font;
use super::tree_state::TreeState;
use crate::layout::{BOX_HEIGHT, BOX_WIDTH, Item, Kind, Layers, Placement, Segment, routes};

/// Number of straight pieces of a curve.
const PIECES: usize = 16;
/// Size of a component, px.
const BOX: Vec2 = Vec2::new(BOX_WIDTH as f32, BOX_HEIGHT as f32);

/// Drawing of the states of one tree; each component has the same position in every picture.
#[derive(Debug)]
pub struct TreeView {
    layers: Layers,
    placement: Placement,
    routes: Vec<Vec<Vec<usize>>>,
    size: Vec2,
}

impl TreeView {
    /// A view of a tree for pictures of `width` × `height` px.
    #[must_use]
    pub fn new(tree: &Description, width: usize, height: usize) -> Self {
        let layers = Layers::new(tree);
        let (placement, routes) = (Placement::new(&layers), routes(tree, &layers));
        Self { layers, placement, routes, size: Vec2::new(width as f32, height as f32) }
    }

    /// Draws the tree in a state.
    #[must_use]
    pub fn draw(&self, tree: &TreeState<'_>) -> Canvas {
        let mut canvas = Canvas::new(self.size.x as usize, self.size.y as usize, PAPER);
        let in_use = self.in_use(tree);
        for (index, segment) in self.layers.segments.iter().enumerate() {
            if in_use[index] {
                self.segment(&mut canvas, segment);
            }
        }
        for node in 0..tree.tree.components.len() {
            self.component(&mut canvas, tree, node);
        }
        canvas
    }

    /// Returns for each segment whether it belongs to a link in use.
    fn in_use(&self, tree: &TreeState<'_>) -> Vec<bool> {
        let mut in_use = vec![false; self.layers.segments.len()];
        for (from, node) in tree.tree.components.iter().enumerate() {
            for (link, way) in node.links.iter().zip(&self.routes[from]).filter(|(link, _)| tree.uses(from, link)) {
                debug_assert!(!way.is_empty(), "no way from {} to node {}", node.name, link.to);
                for &index in way {
                    in_use[index] = true;
                }
            }
        }
        in_use
    }

    /// Upper left corner of an item's box: the layout is stretched to the size of the picture, the boxes are not.
    fn corner(&self, item: usize) -> Vec2 {
        let (x, y) = self.placement.of(item);
        let drawn = Vec2::new(self.placement.width as f32, self.placement.height as f32) - BOX;
        let part = (Vec2::new(x as f32, y as f32) - Vec2::new(0.5 * BOX.x, 0.0)) / drawn;
        part * (self.size - BOX)
    }

    /// Point on the upper edge of an item's box, for a port at `x` in the layout.
    fn port(&self, item: usize, x: f64) -> Vec2 {
        let (middle, _) = self.placement.of(item);
        self.corner(item) + Vec2::new((x - middle) as f32 + 0.5 * BOX.x, 0.0)
    }

    fn segment(&self, canvas: &mut Canvas, segment: &Segment) {
        let ((from, _), (to, _)) = self.placement.ends(segment);
        let (from, to) = (self.port(segment.upper, from) + Vec2::new(0.0, BOX.y), self.port(segment.lower, to));
        let rgb = if segment.kind == LinkKind::Requirement { REQUIRED } else { MODULATED };
        let curve: Vec<Vec2> = bend(from, to).collect();
        canvas.polyline(&curve, 1.6, rgb);
        let is_component = |item: usize| matches!(self.layers.items[item], Item::Component(_));
        match segment.kind {
            LinkKind::Requirement if is_component(segment.upper) => canvas.arrow_head(from, Vec2::NEG_Y, 8.0, rgb),
            LinkKind::Modulation if is_component(segment.lower) => canvas.arrow_head(to, Vec2::Y, 8.0, rgb),
            _ => {}
        }
        if !is_component(segment.lower) {
            canvas.line(to, to + Vec2::new(0.0, BOX.y), 1.6, rgb);
        }
    }

    fn component(&self, canvas: &mut Canvas, tree: &TreeState<'_>, node: usize) {
        let from = self.corner(node);
        let area = Area { from, to: from + BOX };
        let (name, middle, line) = (&*tree.tree.components[node].name, area.centre(), Vec2::new(0.0, 8.0));
        if !tree.active[node] {
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

/// Points of a cubic Bézier curve with vertical ends.
fn bend(from: Vec2, to: Vec2) -> impl Iterator<Item = Vec2> {
    let pull = Vec2::new(0.0, 0.5 * (to.y - from.y));
    (0..=PIECES).map(move |piece| {
        let t = piece as f32 / PIECES as f32;
        let (out, back) = (from.lerp(from + pull, t), (to - pull).lerp(to, t));
        let between = (from + pull).lerp(to - pull, t);
        out.lerp(between, t).lerp(between.lerp(back, t), t)
    })
}
