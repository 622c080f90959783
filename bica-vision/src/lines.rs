//! White lines on the carpet, as straight segments.
//!
//! Columns and rows of a grid are scanned for bright stripes between green; their middles are strung together as long as
//! they go straight on, and what results is followed to its ends. Flat lines come from the columns, steep ones from the
//! rows. A circle comes as several short segments.
//! Cost: half of the pixels below the end of the field, once: 40 µs at 320 × 240, 60 µs at 640 × 480.

mod edge_scan;
mod line_track;
mod ridge;
mod trace;

use glam::Vec2;
use heapless::Vec;

use self::edge_scan::LANES;
use self::line_track::{LineTrack, OPEN};
use self::ridge::Scan;
use crate::colour::Classify;
use crate::field_boundary::FieldBoundary;
use crate::frame::Frame;
use crate::projection::Camera;

/// Segments in a frame; when there are more, the shortest are dropped.
pub const LINES: usize = 32;

/// The lines of a frame.
pub type Lines = Vec<Line, LINES>;

/// Beyond this a line says little of where the robot is, m.
pub const FARTHEST: f32 = 4.5;

/// From one scan to the next, as a part of the frame's height: 4 px at 320 × 240.
const PITCH: f32 = 1.0 / 60.0;
/// The widest line, as a part of the frame's height.
const WIDEST: f32 = 0.18;
/// How far off a line its other pieces may lie and how far beyond its ends, px at 320 × 240.
const APART: f32 = 1.5;
const BETWEEN: f32 = 40.0;
/// Places on a line at which it is cut if its end is not on the ground.
const CUTS: u8 = 16;

/// A straight piece of a white line, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// One end.
    pub from: Vec2,
    /// The other end.
    pub to: Vec2,
}

impl Line {
    /// Length in pixels.
    #[must_use]
    pub fn length(&self) -> f32 {
        self.from.distance(self.to)
    }
}

/// A line with what its pixels look like.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stripe {
    from: Vec2,
    to: Vec2,
    /// Across it, px.
    width: f32,
    /// How much brighter than the carpet it is, of 255.
    rise: f32,
}

impl Stripe {
    fn length(&self) -> f32 {
        self.from.distance(self.to)
    }
}

type Stripes = Vec<Stripe, LINES>;

/// Finds the line segments of a frame below the end of the field. With `camera`, what is wider or narrower on the ground
/// than a line is none.
#[must_use]
pub fn find(
    frame: &Frame<'_>,
    colours: &impl Classify,
    field_boundary: &FieldBoundary,
    camera: Option<&Camera>,
) -> Lines {
    let mut stripes = Stripes::new();
    for axes in [Axes::Columns, Axes::Rows] {
        scan(frame, colours, field_boundary, axes, &mut stripes);
    }
    let scale = f32::from(frame.height()) / 240.0;
    join(&mut stripes, scale * APART, scale * BETWEEN);
    stripes.retain(|stripe| camera.is_none_or(|camera| trace::is_of_width(stripe, camera)));
    stripes.iter_mut().for_each(|stripe| *stripe = trace::to_the_ends(*stripe, frame));
    join(&mut stripes, scale * APART, scale * BETWEEN);
    stripes.iter().map(|stripe| Line { from: stripe.from, to: stripe.to }).collect()
}

/// The parts of lines that are on the ground within `farthest` m: ends on the ground, m, in the camera's ground frame.
#[must_use]
pub fn on_ground(lines: &[Line], camera: &Camera, farthest: f32) -> Vec<Line, LINES> {
    let ground = |pixel: Vec2| camera.ground(pixel, 0.0).filter(|place| place.length() <= farthest);
    let clipped = lines.iter().filter_map(|line| {
        let near =
            |from: Vec2, to: Vec2| (0..=CUTS).find_map(|cut| ground(from.lerp(to, f32::from(cut) / f32::from(CUTS))));
        Some(Line { from: near(line.from, line.to)?, to: near(line.to, line.from)? })
    });
    clipped.filter(|line| line.from != line.to).collect()
}

/// Joins pieces of one line: whose ends lie within `apart` px of the line through the longer one and at most `between`
/// px from its ends.
fn join(lines: &mut Stripes, apart: f32, between: f32) {
    let mut at = 0;
    while at < lines.len() {
        let joined =
            (at + 1..lines.len()).find_map(|other| Some((other, joint(&lines[at], &lines[other], apart, between)?)));
        if let Some((other, line)) = joined {
            lines[at] = line;
            lines.swap_remove(other);
        } else {
            at += 1;
        }
    }
}

fn joint(a: &Stripe, b: &Stripe, apart: f32, between: f32) -> Option<Stripe> {
    let (long, short) = if a.length() >= b.length() { (a, b) } else { (b, a) };
    let length = long.length();
    let along = (long.to - long.from).try_normalize()?;
    let near = |end: Vec2| (along.perp_dot(end - long.from).abs() <= apart).then(|| along.dot(end - long.from));
    let (from, to) = ((near(short.from)?, short.from), (near(short.to)?, short.to));
    let (low, high) = if from.0 <= to.0 { (from, to) } else { (to, from) };
    // Where another line crosses, a piece as wide as that line is missing.
    let between = between.min(0.8 * short.length());
    let meets = low.0 <= length + between && high.0 >= -between;
    let first = if low.0 < 0.0 { low.1 } else { long.from };
    let last = if high.0 > length { high.1 } else { long.to };
    meets.then_some(Stripe { from: first, to: last, ..*long })
}

/// What is scanned: `along` counts in a scan, `across` from scan to scan.
#[derive(Clone, Copy, PartialEq)]
enum Axes {
    Columns,
    Rows,
}

impl Axes {
    fn pixel(self, across: f32, along: f32) -> Vec2 {
        if self == Self::Columns { Vec2::new(across, along) } else { Vec2::new(along, across) }
    }
}

fn scan(frame: &Frame<'_>, colours: &impl Classify, field_boundary: &FieldBoundary, axes: Axes, stripes: &mut Stripes) {
    let Some(top) = field_boundary.top() else { return };
    let (side, end) = match axes {
        Axes::Columns => (frame.width(), frame.height()),
        Axes::Rows => (frame.height(), frame.width()),
    };
    let pitch = ((PITCH * f32::from(frame.height())) as u16).max(2);
    let widest = (WIDEST * f32::from(frame.height())) as u16;
    let first = |across: u16| match axes {
        Axes::Columns => (field_boundary.row_at(across.into()).unwrap_or(top) as u16).min(end),
        Axes::Rows if f32::from(across) >= top => 0,
        Axes::Rows => end,
    };
    let mut open: Vec<LineTrack, OPEN> = Vec::new();
    let mut scans = (pitch / 2..side)
        .step_by(pitch.into())
        .map(|across| (Scan { frame, colours, axes, across, widest }, first(across)));
    loop {
        let together: Vec<_, LANES> = scans.by_ref().take(LANES).collect();
        if together.is_empty() {
            break;
        }
        for ((scan, _), ridges) in together.iter().zip(ridge::side_by_side(&together, end)) {
            let place = f32::from(scan.across);
            for ridge in ridges {
                let pixel = axes.pixel(place, ridge.at);
                if field_boundary.is_below(pixel.x, pixel.y, 0.0) {
                    line_track::string(&mut open, place, ridge, pitch.into());
                }
            }
            line_track::close(&mut open, axes, place - 1.5 * f32::from(pitch), |stripe| keep(stripes, stripe));
        }
    }
    line_track::close(&mut open, axes, f32::MAX, |stripe| keep(stripes, stripe));
}

fn keep(stripes: &mut Stripes, stripe: Stripe) {
    let Err(stripe) = stripes.push(stripe) else { return };
    let shortest = stripes.iter_mut().min_by(|a, b| a.length().total_cmp(&b.length()));
    if let Some(shortest) = shortest.filter(|shortest| shortest.length() < stripe.length()) {
        *shortest = stripe;
    }
}
