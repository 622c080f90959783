//! Samples: pixels with a known class, or with classes that are known to be wrong.
//!
//! A pixel in a rectangle is of its class and of no other. In a rectangle without a class a pixel may be white, as
//! walls are. In a labelled image, pixels inside an orange ball are orange, pixels outside all balls are not orange,
//! and pixels outside the goal are neither yellow nor blue. Edges, where colours mix, are excluded. All rectangles and
//! balls of a class have the same weight, independent of their size; a red ball weighs as much as an orange one.

use bica_vision::colour::{Colour, ColourSet};
use bica_vision::frame::{Frame, Pair, Pixel};
use glam::Vec2;

use super::rectangles::Rectangle;
use crate::labels::{Ball, Goal, Label};

/// Distance between two sampled rows of the background, px.
const BACKGROUND_ROW_STEP: usize = 4;
/// Margin around a goal's box in which its colour may occur, px.
const GOAL_MARGIN: f32 = 12.0;

/// Pixel with its known class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    /// Index of the image in the order of names.
    pub(super) image: usize,
    /// The pixel.
    pub(super) pixel: Pixel,
    /// Its class, if known.
    pub(super) is: Option<Colour>,
    /// Classes to which it is known not to belong.
    pub(super) is_not: ColourSet,
    /// Number of pixels that the sample represents.
    pub(super) weight: f32,
}

/// Samples, grouped by rectangle or ball.
#[derive(Debug, Default)]
pub(super) struct Samples {
    groups: Vec<(Colour, Vec<Sample>)>,
    background: Vec<Sample>,
}

impl Samples {
    /// Adds the part of a rectangle that lies in the image.
    pub(super) fn add_rectangle(&mut self, image: usize, frame: &Frame<'_>, rectangle: &Rectangle) {
        let Rectangle { x, y, class, .. } = rectangle;
        let inside = |at: Vec2| (f32::from(x[0])..f32::from(x[1]) - 1.0).contains(&(at.x - 0.5));
        let rows = pairs(frame).filter(|(at, _)| (f32::from(y[0])..f32::from(y[1])).contains(&at.y));
        let pixels = rows.filter(|(at, _)| inside(*at)).map(|(_, pixel)| pixel);
        let is_not = others(*class);
        let is = Some(*class).filter(|class| *class != Colour::None);
        let samples = pixels.map(|pixel| Sample { image, pixel, is, is_not, weight: 1.0 }).collect();
        match is {
            Some(class) => self.groups.push((class, samples)),
            None => self.background.extend(samples),
        }
    }

    /// Adds a labelled image.
    pub(super) fn add_label(&mut self, image: usize, frame: &Frame<'_>, label: &Label) {
        for ball in label.balls.iter().filter(|ball| ball.orange) {
            let sample =
                |pixel| Sample { image, pixel, is: Some(Colour::Orange), is_not: others(Colour::Orange), weight: 1.0 };
            self.groups.push((Colour::Orange, inside(frame, ball).map(sample).collect()));
        }
        for ball in label.balls.iter().filter(|ball| !ball.orange) {
            let sample = |pixel| Sample { image, pixel, is: None, is_not: ColourSet::of(Colour::Orange), weight: 1.0 };
            self.groups.push((Colour::Orange, inside(frame, ball).map(sample).collect()));
        }
        for (at, pixel) in pairs(frame).filter(|(at, _)| (at.y as usize).is_multiple_of(BACKGROUND_ROW_STEP)) {
            let is_not = absent(at, label);
            if is_not != ColourSet::EMPTY {
                self.background.push(Sample { image, pixel, is: None, is_not, weight: BACKGROUND_ROW_STEP as f32 });
            }
        }
    }

    /// Returns all samples, weighted so that all groups of a class have the same total weight.
    pub(super) fn weighted(self) -> Vec<Sample> {
        let Self { mut groups, background } = self;
        groups.retain(|(_, samples)| !samples.is_empty());
        for class in Colour::ALL {
            let sizes = groups.iter().filter(|(of, _)| *of == class).map(|(_, samples)| samples.len());
            let (count, total) = sizes.fold((0, 0), |(count, total), size| (count + 1, total + size));
            for (_, samples) in groups.iter_mut().filter(|(of, _)| *of == class) {
                let weight = total as f32 / (count * samples.len()) as f32;
                for sample in samples {
                    sample.weight = weight;
                }
            }
        }
        groups.into_iter().flat_map(|(_, samples)| samples).chain(background).collect()
    }
}

/// Pixel pairs of a frame with the positions of their centres.
fn pairs<'a>(frame: &Frame<'a>) -> impl Iterator<Item = (Vec2, Pixel)> + use<'a> {
    let frame = *frame;
    let row = move |y: u16| frame.row(y).iter().enumerate().map(move |(x, pair)| (x, y, Pair(*pair).mean()));
    (0..frame.height()).flat_map(row).map(|(x, y, pixel)| (Vec2::new(2.0 * x as f32 + 0.5, y.into()), pixel))
}

/// Pixels of a ball, without its edge.
fn inside<'a>(frame: &Frame<'a>, ball: &Ball) -> impl Iterator<Item = Pixel> + use<'a> {
    let Ball { centre, radius, .. } = *ball;
    pairs(frame).filter(move |(at, _)| at.distance(centre) <= 0.85 * radius - 0.5).map(|(_, pixel)| pixel)
}

/// Classes to which a pixel of a class does not belong; a pixel of no class may be white.
fn others(class: Colour) -> ColourSet {
    let is_open = |other: &Colour| class == Colour::None && *other == Colour::White;
    let others = Colour::ALL.into_iter().filter(|other| *other != class && !is_open(other));
    others.fold(ColourSet::EMPTY, |set, other| set | ColourSet::of(other))
}

/// Classes that do not occur at a position of a labelled image.
fn absent(at: Vec2, label: &Label) -> ColourSet {
    let far_from_ball = |ball: &Ball| !ball.orange || at.distance(ball.centre) > 1.25 * ball.radius + 2.0;
    let far_from_goal = |goal: &Goal| {
        let (min, max) = (goal.min - GOAL_MARGIN, goal.max + GOAL_MARGIN);
        at.cmplt(min).any() || at.cmpgt(max).any()
    };
    let orange = if label.balls.iter().all(far_from_ball) { ColourSet::of(Colour::Orange) } else { ColourSet::EMPTY };
    let goals = Colour::Yellow | Colour::Blue;
    if label.goal.iter().all(far_from_goal) { orange | goals } else { orange }
}
