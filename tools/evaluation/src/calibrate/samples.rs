//! Pixels of which something is known, from rectangles and from labelled images.
//!
//! A pixel in a rectangle is of its class and of no other; in one of no class it may be white, as walls are. In a labelled image what is in an orange ball is orange, what
//! is outside all of them is not; what is outside the goal is neither yellow nor blue. Edges, where colours mix, are left
//! out. Each rectangle and each ball counts as much as any other of its class, whatever its size; a red ball as much as
//! an orange one.

use bica_vision::colour::{Colour, ColourSet};
use bica_vision::frame::{Frame, Pair, Pixel};
use glam::Vec2;

use super::rectangles::Rectangle;
use crate::labels::{Ball, Goal, Label};

/// Rows of an image whose background is looked at: every fourth.
const ROWS: usize = 4;
/// How far around a goal's box its colour may be, px.
const AROUND_GOAL: f32 = 12.0;

/// A pixel, and what it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The image, by its place in the order of names.
    pub image: usize,
    pub pixel: Pixel,
    /// The class that it has, if that is known.
    pub is: Option<Colour>,
    /// Classes that it has not.
    pub is_not: ColourSet,
    /// How many pixels it stands for.
    pub weight: f32,
}

/// Things of one class that weigh the same together.
#[derive(Debug, Default)]
pub struct Samples {
    things: Vec<(Colour, Vec<Sample>)>,
    background: Vec<Sample>,
}

impl Samples {
    /// Takes in a rectangle of an image, as far as it is in it.
    pub fn add_rectangle(&mut self, image: usize, frame: &Frame<'_>, rectangle: &Rectangle) {
        let Rectangle { x, y, class, .. } = rectangle;
        let inside = |at: Vec2| (f32::from(x[0])..f32::from(x[1]) - 1.0).contains(&(at.x - 0.5));
        let rows = pairs(frame).filter(|(at, _)| (f32::from(y[0])..f32::from(y[1])).contains(&at.y));
        let pixels = rows.filter(|(at, _)| inside(*at)).map(|(_, pixel)| pixel);
        let is_not = others(*class);
        let is = Some(*class).filter(|class| *class != Colour::None);
        let samples = pixels.map(|pixel| Sample { image, pixel, is, is_not, weight: 1.0 }).collect();
        match is {
            Some(class) => self.things.push((class, samples)),
            None => self.background.extend(samples),
        }
    }

    /// Takes in a labelled image.
    pub fn add_label(&mut self, image: usize, frame: &Frame<'_>, label: &Label) {
        for ball in label.balls.iter().filter(|ball| ball.orange) {
            let sample =
                |pixel| Sample { image, pixel, is: Some(Colour::Orange), is_not: others(Colour::Orange), weight: 1.0 };
            self.things.push((Colour::Orange, inside(frame, ball).map(sample).collect()));
        }
        for ball in label.balls.iter().filter(|ball| !ball.orange) {
            let sample = |pixel| Sample { image, pixel, is: None, is_not: ColourSet::of(Colour::Orange), weight: 1.0 };
            self.things.push((Colour::Orange, inside(frame, ball).map(sample).collect()));
        }
        for (at, pixel) in pairs(frame).filter(|(at, _)| (at.y as usize).is_multiple_of(ROWS)) {
            let is_not = absent(at, label);
            if is_not != ColourSet::EMPTY {
                self.background.push(Sample { image, pixel, is: None, is_not, weight: ROWS as f32 });
            }
        }
    }

    /// All of them, those of each class with the same weight for each thing.
    pub fn weighed(self) -> Vec<Sample> {
        let Self { mut things, background } = self;
        things.retain(|(_, samples)| !samples.is_empty());
        for class in Colour::ALL {
            let sizes = things.iter().filter(|(of, _)| *of == class).map(|(_, samples)| samples.len());
            let (count, total) = sizes.fold((0, 0), |(count, total), size| (count + 1, total + size));
            for (_, samples) in things.iter_mut().filter(|(of, _)| *of == class) {
                let weight = total as f32 / (count * samples.len()) as f32;
                for sample in samples {
                    sample.weight = weight;
                }
            }
        }
        things.into_iter().flat_map(|(_, samples)| samples).chain(background).collect()
    }
}

/// The pairs of a frame with their places; a place is between two pixels.
fn pairs<'a>(frame: &Frame<'a>) -> impl Iterator<Item = (Vec2, Pixel)> + use<'a> {
    let frame = *frame;
    let row = move |y: u16| frame.row(y).iter().enumerate().map(move |(x, pair)| (x, y, Pair(*pair).mean()));
    (0..frame.height()).flat_map(row).map(|(x, y, pixel)| (Vec2::new(2.0 * x as f32 + 0.5, y.into()), pixel))
}

/// The pixels of a ball, without its edge.
fn inside<'a>(frame: &Frame<'a>, ball: &Ball) -> impl Iterator<Item = Pixel> + use<'a> {
    let Ball { centre, radius, .. } = *ball;
    pairs(frame).filter(move |(at, _)| at.distance(centre) <= 0.85 * radius - 0.5).map(|(_, pixel)| pixel)
}

/// What a pixel of a class is not; one of no class may be white.
fn others(class: Colour) -> ColourSet {
    let is_open = |other: &Colour| class == Colour::None && *other == Colour::White;
    let others = Colour::ALL.into_iter().filter(|other| *other != class && !is_open(other));
    others.fold(ColourSet::EMPTY, |set, other| set | ColourSet::of(other))
}

/// What is not at a place of a labelled image.
fn absent(at: Vec2, label: &Label) -> ColourSet {
    let far_from_ball = |ball: &Ball| !ball.orange || at.distance(ball.centre) > 1.25 * ball.radius + 2.0;
    let far_from_goal = |goal: &Goal| {
        let (min, max) = (goal.min - AROUND_GOAL, goal.max + AROUND_GOAL);
        at.cmplt(min).any() || at.cmpgt(max).any()
    };
    let orange = if label.balls.iter().all(far_from_ball) { ColourSet::of(Colour::Orange) } else { ColourSet::EMPTY };
    let goals = Colour::Yellow | Colour::Blue;
    if label.goal.iter().all(far_from_goal) { orange | goals } else { orange }
}
