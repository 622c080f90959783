//! A whole picture: camera on the left, map on the right, the tree below.

use bica::graph::Graph;
use bica_motion::robot::Image;
use glam::Vec2;

use super::camera;
use super::canvas::Canvas;
use super::field_map::{self, Map};
use super::palette::{FAINT, PAPER, TEXT};
use super::scene::{Beliefs, Marks, TreeNow, Truth};
use super::text::Font;
use super::tree_view::{self, TreeView};

const MARGIN: usize = 20;
const HEAD: usize = 56;
const PANEL: (usize, usize) = (640, 480);
const LEGEND: usize = 30;
const TREE: (usize, usize) = (2 * PANEL.0 + MARGIN, 430);

/// One moment of a game.
pub struct Moment<'a> {
    pub title: &'a str,
    pub subtitle: &'a str,
    pub image: Option<Image<'a>>,
    pub marks: &'a Marks,
    pub beliefs: &'a Beliefs,
    pub truth: &'a Truth,
    pub tree: &'a TreeNow,
}

/// Draws the moments of a game.
pub struct Sheet {
    tree: TreeView,
}

impl Sheet {
    /// Makes ready for a tree.
    pub fn new(graph: &Graph) -> Self {
        Self { tree: TreeView::new(graph, TREE.0, TREE.1) }
    }

    /// Draws one moment.
    pub fn draw(&self, moment: &Moment<'_>) -> Canvas {
        let below = HEAD + PANEL.1 + LEGEND;
        let mut sheet = Canvas::new(TREE.0 + 2 * MARGIN, below + TREE.1 + LEGEND + MARGIN, PAPER);
        sheet.write(Vec2::new(MARGIN as f32, 10.0), Font::Title, TEXT, moment.title);
        sheet.write(Vec2::new(MARGIN as f32, 33.0), Font::Normal, FAINT, moment.subtitle);
        if let Some(image) = &moment.image {
            sheet.place(&camera::view(image, moment.marks, PANEL.0), MARGIN, HEAD);
        }
        let mut map = Map::new(PANEL.0, moment.truth.attacks);
        map.truth(moment.truth);
        map.beliefs(moment.beliefs);
        sheet.place(&map.into_canvas(), 2 * MARGIN + PANEL.0, HEAD);
        let legend = (HEAD + PANEL.1) as f32 + 4.0;
        field_map::legend(&mut sheet, Vec2::new((2 * MARGIN + PANEL.0) as f32, legend - 11.0));
        sheet.place(&self.tree.draw(moment.tree), MARGIN, below);
        tree_view::legend(&mut sheet, Vec2::new(MARGIN as f32, (below + TREE.1) as f32 + 12.0));
        sheet
    }
}
