//! Picture of a game: camera image on the left, field map on the right, activation tree below.

use bica_drawing::TreeState;
use bica_drawing::canvas::Canvas;
use bica_drawing::palette::{FAINT, PAPER, TEXT};
use bica_drawing::text::Font;
use bica_drawing::tree_view::{self, TreeView};
use bica_evaluation::pictures::{Marks, camera};
use bica_motion::robot::Image;
use glam::Vec2;

use super::super::scene::TREE;
use super::field_map::{self, Map};
use super::state::{Estimates, GroundTruth};

/// Margin around and between the parts, px.
const MARGIN: usize = 20;
/// Height of the title, px.
const TITLE_HEIGHT: usize = 56;
/// Size of the camera image and of the map, px.
const PANEL_WIDTH: usize = 640;
const PANEL_HEIGHT: usize = 480;
/// Height of a legend, px.
const LEGEND_HEIGHT: usize = 30;
/// Size of the tree, px.
const TREE_WIDTH: usize = 2 * PANEL_WIDTH + MARGIN;
const TREE_HEIGHT: usize = 430;

/// Content of a sheet.
#[derive(Debug)]
pub(crate) struct Snapshot<'a> {
    /// First line.
    pub(crate) title: &'a str,
    /// Second line.
    pub(crate) subtitle: &'a str,
    /// Camera image.
    pub(crate) image: Option<Image<'a>>,
    /// Detections in the image.
    pub(crate) marks: &'a Marks,
    /// Estimates of the robot.
    pub(crate) estimates: &'a Estimates,
    /// True state of the game.
    pub(crate) truth: &'a GroundTruth,
    /// State of the tree.
    pub(crate) tree: &'a TreeState<'a>,
}

/// Renderer of a game's sheets.
#[derive(Debug)]
pub(crate) struct Sheet {
    tree: TreeView,
}

impl Sheet {
    /// Creates the renderer.
    #[must_use]
    pub(crate) fn new() -> Self {
        Self { tree: TreeView::new(&TREE, TREE_WIDTH, TREE_HEIGHT) }
    }

    /// Draws one sheet.
    #[must_use]
    pub(crate) fn draw(&self, moment: &Snapshot<'_>) -> Canvas {
        let below = TITLE_HEIGHT + PANEL_HEIGHT + LEGEND_HEIGHT;
        let mut sheet = Canvas::new(TREE_WIDTH + 2 * MARGIN, below + TREE_HEIGHT + LEGEND_HEIGHT + MARGIN, PAPER);
        sheet.write(Vec2::new(MARGIN as f32, 10.0), Font::Title, TEXT, moment.title);
        sheet.write(Vec2::new(MARGIN as f32, 33.0), Font::Normal, FAINT, moment.subtitle);
        if let Some(image) = &moment.image {
            sheet.place(&camera::view(image, moment.marks, PANEL_WIDTH), MARGIN, TITLE_HEIGHT);
        }
        let mut map = Map::new(PANEL_WIDTH, moment.truth.attacks);
        map.truth(moment.truth);
        map.estimates(moment.estimates);
        sheet.place(&map.into_canvas(), 2 * MARGIN + PANEL_WIDTH, TITLE_HEIGHT);
        let legend = (TITLE_HEIGHT + PANEL_HEIGHT) as f32 + 4.0;
        field_map::legend(&mut sheet, Vec2::new((2 * MARGIN + PANEL_WIDTH) as f32, legend - 11.0));
        sheet.place(&self.tree.draw(moment.tree), MARGIN, below);
        tree_view::legend(&mut sheet, Vec2::new(MARGIN as f32, (below + TREE_HEIGHT) as f32 + 12.0));
        sheet
    }
}
