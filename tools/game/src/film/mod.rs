//! A film of a game: the world from outside, the robot's own view beside it, and what it does.

mod cameraman;
mod colours;
mod gif;

use std::path::Path;
use std::time::Duration;

use bica_motion::robot::Image;
use bica_sim::{Picture, Referee};
use glam::Vec2;

use crate::observer::{Observer, View};
use crate::scene::Scene;
use bica_console::Failure;
use bica_drawing::camera;
use bica_drawing::canvas::Canvas;
use bica_drawing::palette::{FAINT, PAPER, TEXT};
use bica_drawing::polar::words;
use bica_drawing::text::Font;
use cameraman::Cameraman;
use gif::{Gif, TIME};

/// From picture to picture.
const EVERY: Duration = Duration::from_millis(10 * TIME as u64);
/// The robot's own view changes with every so many pictures: its noise is most of a file.
const OWN_EVERY: u32 = 3;
/// How long the last picture stays, pictures.
const LAST: u16 = 35;
/// The size of the view from outside, pixels.
pub const OUTSIDE: (usize, usize) = (480, 360);
/// The size of the robot's own view, pixels.
const OWN: (usize, usize) = (320, 240);
/// The most components that are named.
const NAMED: usize = 8;

/// Someone who films a game.
pub struct Film {
    gif: Gif,
    cameraman: Cameraman,
    next: Duration,
    last: Option<Canvas>,
    /// The robot's own view, and how many pictures it stays.
    own: Option<(Canvas, u32)>,
}

impl Film {
    /// Makes the file.
    pub fn new(path: &Path) -> Result<Self, Failure> {
        let gif = Gif::new(path, OUTSIDE.0 + OWN.0, OUTSIDE.1)?;
        Ok(Self { gif, cameraman: Cameraman::new(), next: Duration::ZERO, last: None, own: None })
    }

    /// Lets the last picture stay for a while, and closes the file. Says how many pictures there are.
    pub fn end(mut self) -> Result<usize, Failure> {
        if let Some(last) = self.last.take() {
            self.gif.add(&last, LAST)?;
        }
        self.gif.end()
    }
}

impl Observer for Film {
    fn looks_from(&mut self, now: Duration, referee: &Referee) -> Option<View> {
        if now < self.next {
            return None;
        }
        self.next += EVERY;
        let (width, height) = OUTSIDE;
        Some(View { from: self.cameraman.follow(referee, EVERY.as_secs_f32()), width, height })
    }

    fn watched(&mut self, scene: &Scene<'_>, picture: &Picture) -> Result<(), Failure> {
        if let Some(last) = self.last.take() {
            self.gif.add(&last, 1)?;
        }
        if let Some(image) = scene.image().filter(|_| self.own.as_ref().is_none_or(|(_, left)| *left == 0)) {
            self.own = Some((own_view(scene, &image), OWN_EVERY));
        }
        let own = self.own.as_mut().map(|(view, left)| {
            *left -= 1;
            &*view
        });
        self.last = Some(sheet(scene, picture, own));
        Ok(())
    }
}

/// Both views and the words.
fn sheet(scene: &Scene<'_>, picture: &Picture, own: Option<&Canvas>) -> Canvas {
    let mut sheet = Canvas::new(OUTSIDE.0 + OWN.0, OUTSIDE.1, PAPER);
    let mut outside = Canvas::new(picture.width, picture.height, PAPER);
    for (i, rgb) in picture.rgb.iter().enumerate() {
        outside.set(i % picture.width, i / picture.width, *rgb);
    }
    sheet.place(&outside, 0, 0);
    if let Some(own) = own {
        sheet.place(own, OUTSIDE.0, 0);
    }
    write(&mut sheet, scene);
    sheet
}

/// What the robot sees, with what it recognises.
fn own_view(scene: &Scene<'_>, image: &Image<'_>) -> Canvas {
    let view = camera::view(image, &scene.marks(), OWN.0);
    if view.width() == OWN.0 {
        return view;
    }
    let pixels = view.bytes().as_chunks::<3>().0;
    let mut small = Canvas::new(OWN.0, OWN.1, PAPER);
    for (x, y) in (0..OWN.1).flat_map(|y| (0..OWN.0).map(move |x| (x, y))) {
        let (column, row) = (x * view.width() / OWN.0, y * view.height() / OWN.1);
        small.set(x, y, pixels[row * view.width() + column]);
    }
    small
}

fn write(sheet: &mut Canvas, scene: &Scene<'_>) {
    let tree = scene.tree();
    let state = tree.state(tree.graph.root).unwrap_or("-");
    let (ball, goal) = scene.sights();
    let line = |row: usize| Vec2::new(OUTSIDE.0 as f32 + 12.0, OWN.1 as f32 + 8.0 + 18.0 * row as f32);
    sheet.write(line(0), Font::Title, TEXT, &format!("{:6.1} s  {state}", scene.t));
    sheet.write(line(1), Font::Normal, TEXT, &format!("ball {}", words(ball)));
    sheet.write(line(2), Font::Normal, TEXT, &format!("goal {}", words(goal)));
    let activates = |node: &usize| tree.active[*node] && *node != tree.graph.root;
    let nodes = (0..tree.active.len()).filter(activates).filter(|node| !tree.graph.nodes[*node].links.is_empty());
    let names: Vec<&str> = nodes.take(NAMED).map(|node| tree.graph.nodes[node].name).collect();
    for (row, names) in names.chunks(NAMED / 2).enumerate() {
        sheet.write(line(3 + row), Font::Small, FAINT, &names.join("  "));
    }
}
