//! Film of a game: the outside view, the robot's camera image, and the active components.

pub(crate) mod camera_operator;
mod colours;
pub(crate) mod gif;

use std::path::Path;
use std::time::Duration;

use bica_app::Failure;
use bica_drawing::TreeState;
use bica_drawing::canvas::Canvas;
use bica_drawing::palette::{FAINT, PAPER, TEXT};
use bica_drawing::text::Font;
use bica_evaluation::pictures::camera;
use bica_evaluation::polar::{Polar, describe};
use bica_motion::robot::Image;
use bica_sim::{Picture, Referee};
use glam::Vec2;

use crate::game::observer::{GameObserver, View};
use crate::game::scene::Scene;
use camera_operator::{CameraOperator, Site};
use gif::{Gif, PICTURE_TIME};

/// Time between two pictures.
pub(crate) const INTERVAL: Duration = Duration::from_millis(10 * PICTURE_TIME as u64);
/// Number of pictures that share one camera image: its noise makes up most of a file.
const CAMERA_REPEAT: u32 = 3;
/// Duration of the last picture, as a number of pictures.
pub(crate) const LAST_REPEAT: u16 = 35;
/// Size of the view from outside, px.
pub(crate) const OUTSIDE_WIDTH: usize = 480;
pub(crate) const OUTSIDE_HEIGHT: usize = 360;
/// Size of the camera image, px.
pub(crate) const CAMERA_WIDTH: usize = 320;
pub(crate) const CAMERA_HEIGHT: usize = 240;
/// Largest number of components that are named.
const MAX_NAMES: usize = 8;

/// Observer that films a game.
pub(crate) struct Film {
    gif: Gif,
    operator: CameraOperator,
    next: Duration,
    last: Option<Canvas>,
    /// Camera image, and the number of pictures until its next change.
    camera_view: Option<(Canvas, u32)>,
}

impl Film {
    /// Creates the file of a film, without pictures.
    pub(crate) fn new(path: &Path) -> Result<Self, Failure> {
        let gif = Gif::new(path, OUTSIDE_WIDTH + CAMERA_WIDTH, OUTSIDE_HEIGHT)?;
        Ok(Self { gif, operator: CameraOperator::new(Site::HALL), next: Duration::ZERO, last: None, camera_view: None })
    }

    /// Adds the last picture, closes the file, and returns the number of pictures.
    pub(crate) fn finish(mut self) -> Result<usize, Failure> {
        if let Some(last) = self.last.take() {
            self.gif.add(&last, LAST_REPEAT)?;
        }
        self.gif.finish()
    }
}

impl GameObserver for Film {
    fn view(&mut self, now: Duration, referee: &Referee) -> Option<View> {
        if now < self.next {
            return None;
        }
        self.next += INTERVAL;
        let others = referee.others().iter().map(|other| other.position).collect();
        let camera = self.operator.follow(referee.robot().position, referee.ball(), others, INTERVAL.as_secs_f32());
        Some(View { camera, width: OUTSIDE_WIDTH, height: OUTSIDE_HEIGHT })
    }

    fn rendered(&mut self, scene: &Scene<'_>, picture: &Picture) -> Result<(), Failure> {
        if let Some(last) = self.last.take() {
            self.gif.add(&last, 1)?;
        }
        if let Some(image) = scene.image().filter(|_| self.camera_view.as_ref().is_none_or(|(_, left)| *left == 0)) {
            self.camera_view = Some((camera_view(scene, &image), CAMERA_REPEAT));
        }
        let own = self.camera_view.as_mut().map(|(view, left)| {
            *left -= 1;
            &*view
        });
        let (ball, goal) = scene.positions();
        self.last = Some(sheet(picture, own, scene.t, &scene.tree(), [ball, goal]));
        Ok(())
    }
}

/// Draws one picture: both views, the time, the tree, and the positions of ball and goal.
pub(crate) fn sheet(
    picture: &Picture,
    own: Option<&Canvas>,
    t: f64,
    tree: &TreeState<'_>,
    positions: [Option<Polar>; 2],
) -> Canvas {
    let mut sheet = Canvas::new(OUTSIDE_WIDTH + CAMERA_WIDTH, OUTSIDE_HEIGHT, PAPER);
    let mut outside = Canvas::new(picture.width, picture.height, PAPER);
    for (i, rgb) in picture.rgb.iter().enumerate() {
        outside.set(i % picture.width, i / picture.width, *rgb);
    }
    sheet.place(&outside, 0, 0);
    if let Some(own) = own {
        sheet.place(own, OUTSIDE_WIDTH, 0);
    }
    write(&mut sheet, t, tree, positions);
    sheet
}

/// Draws the camera image with detections.
fn camera_view(scene: &Scene<'_>, image: &Image<'_>) -> Canvas {
    let view = camera::view(image, &scene.marks(), CAMERA_WIDTH);
    if view.width() == CAMERA_WIDTH {
        return view;
    }
    let pixels = view.bytes().as_chunks::<3>().0;
    let mut small = Canvas::new(CAMERA_WIDTH, CAMERA_HEIGHT, PAPER);
    for (x, y) in (0..CAMERA_HEIGHT).flat_map(|y| (0..CAMERA_WIDTH).map(move |x| (x, y))) {
        let (column, row) = (x * view.width() / CAMERA_WIDTH, y * view.height() / CAMERA_HEIGHT);
        small.set(x, y, pixels[row * view.width() + column]);
    }
    small
}

fn write(sheet: &mut Canvas, t: f64, tree: &TreeState<'_>, [ball, goal]: [Option<Polar>; 2]) {
    let state = tree.state(tree.tree.root).unwrap_or("-");
    let line = |row: usize| Vec2::new(OUTSIDE_WIDTH as f32 + 12.0, CAMERA_HEIGHT as f32 + 8.0 + 18.0 * row as f32);
    sheet.write(line(0), Font::Title, TEXT, &format!("{t:6.1} s  {state}"));
    sheet.write(line(1), Font::Normal, TEXT, &format!("ball {}", describe(ball)));
    sheet.write(line(2), Font::Normal, TEXT, &format!("goal {}", describe(goal)));
    let activates = |node: &usize| *node != tree.tree.root && !tree.tree.components[*node].links.is_empty();
    let nodes = tree.active().filter(activates);
    let names: Vec<&str> = nodes.take(MAX_NAMES).map(|node| &*tree.tree.components[node].name).collect();
    for (row, names) in names.chunks(MAX_NAMES / 2).enumerate() {
        sheet.write(line(3 + row), Font::Small, FAINT, &names.join("  "));
    }
}
