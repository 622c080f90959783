//! White lines on the carpet, as straight segments.
//!
//! Columns and rows of a grid are scanned for white between green; the middles are strung together as long as they go
//! straight on. Flat lines come from the columns, steep ones from the rows. A circle comes as several short segments.
//! Cost: at most 16 000 pixels at 320 × 240, 40 µs with the strings.

use glam::Vec2;
use heapless::Vec;

use crate::colour::{Classify, Colour};
use crate::field_end::FieldEnd;
use crate::frame::{Frame, Pair};
use crate::projection::Camera;

/// Segments in a frame; when there are more, the shortest are dropped.
pub const LINES: usize = 24;

/// The lines of a frame.
pub type Lines = Vec<Line, LINES>;

/// Scan lines along each side of the frame.
const SCANS: u16 = 40;
/// Strings that are followed at a time.
const OPEN: usize = 24;
/// A line with fewer points is none.
const ENOUGH: u16 = 4;
/// The widest line, as a part of the frame's height.
const WIDEST: f32 = 0.18;
/// Pixels of no class between a line and the carpet.
const SEAM: u16 = 2;
/// How far off a line its other pieces may lie and how far beyond its ends, px at 320 × 240.
const APART: f32 = 2.0;
const BETWEEN: f32 = 40.0;
/// Places on a line at which it is cut if its end is not on the ground.
const CUTS: u8 = 16;
/// Crossings of one scan with lines.
const MIDDLES: usize = 16;

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

/// Finds the line segments of a frame below the end of the field. Only white and green are asked for.
#[must_use]
pub fn find(frame: &Frame<'_>, colours: &impl Classify, field_end: &FieldEnd) -> Vec<Line, LINES> {
    let mut lines = Vec::new();
    for axes in [Axes::Columns, Axes::Rows] {
        scan(frame, colours, field_end, axes, &mut lines);
    }
    let scale = f32::from(frame.height()) / 240.0;
    join(&mut lines, scale * APART, scale * BETWEEN);
    lines
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
fn join(lines: &mut Vec<Line, LINES>, apart: f32, between: f32) {
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

fn joint(a: &Line, b: &Line, apart: f32, between: f32) -> Option<Line> {
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
    meets.then_some(Line { from: first, to: last })
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

/// Points that go straight on from scan to scan, with the sums for a least squares fit.
#[derive(Clone, Copy)]
struct Strand {
    first: Vec2,
    last: Vec2,
    slope: f32,
    count: u16,
    sums: [f32; 4],
}

impl Strand {
    fn new(point: Vec2) -> Self {
        Self { first: point, last: point, slope: 0.0, count: 1, sums: [0.0; 4] }
    }

    /// How far a point is from where the strand goes on; none if it is not the next one.
    fn miss(&self, point: Vec2, pitch: f32) -> Option<f32> {
        let ahead = point.x - self.last.x;
        let miss = (point.y - self.last.y - self.slope * ahead).abs();
        let allowed = if self.count == 1 { 1.1 * ahead } else { 1.2 + 0.15 * ahead };
        (ahead > 0.0 && ahead < 2.5 * pitch && miss <= allowed).then_some(miss)
    }

    fn add(&mut self, point: Vec2) {
        let offset = point - self.first;
        let terms = [offset.x, offset.y, offset.x * offset.x, offset.x * offset.y];
        self.sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        self.count += 1;
        self.last = point;
        self.slope = self.fitted().0;
    }

    /// Slope and offset of the fitted line, from the first point on.
    fn fitted(&self) -> (f32, f32) {
        let (n, [x, y, xx, xy]) = (f32::from(self.count), self.sums);
        let slope = (n * xy - x * y) / (n * xx - x * x).max(1e-3);
        (slope, (y - slope * x) / n)
    }

    /// The fitted segment, if it is long enough and no steeper than a diagonal.
    fn line(&self, axes: Axes) -> Option<Line> {
        let (slope, offset) = self.fitted();
        let at = |across: f32| axes.pixel(across, self.first.y + offset + slope * (across - self.first.x));
        let is_line = self.count >= ENOUGH && slope.abs() <= 1.0;
        is_line.then(|| Line { from: at(self.first.x), to: at(self.last.x) })
    }
}

fn scan(frame: &Frame<'_>, colours: &impl Classify, field_end: &FieldEnd, axes: Axes, lines: &mut Vec<Line, LINES>) {
    let Some(top) = field_end.top() else { return };
    let side = if axes == Axes::Columns { frame.width() } else { frame.height() };
    let pitch = f32::from(side) / f32::from(SCANS);
    let mut open: Vec<Strand, OPEN> = Vec::new();
    for index in 0..SCANS {
        let across = libm::floorf((f32::from(index) + 0.5) * pitch);
        let found = match axes {
            Axes::Columns => column(frame, colours, across as u16, field_end.row_at(across).unwrap_or(top) as u16),
            Axes::Rows if across >= top => row(frame, colours, across as u16),
            Axes::Rows => Vec::new(),
        };
        for along in found {
            let pixel = axes.pixel(across, along);
            if field_end.is_below(pixel.x, pixel.y, 0.0) {
                string(&mut open, Vec2::new(across, along), pitch);
            }
        }
        close(&mut open, axes, across - 1.5 * pitch, lines);
    }
    close(&mut open, axes, f32::MAX, lines);
}

fn widest(frame: &Frame<'_>) -> u16 {
    (WIDEST * f32::from(frame.height())) as u16
}

/// The middles of white in a column from a row downwards.
fn column(frame: &Frame<'_>, colours: &impl Classify, x: u16, first: u16) -> Vec<f32, MIDDLES> {
    let classes = (first..frame.height()).map(|y| {
        let pixel = frame.pixel(i32::from(x), i32::from(y));
        (y, pixel.map_or(Colour::None, |pixel| colours.classify(pixel)))
    });
    middles(classes, 1, widest(frame))
}

/// The middles of white in a row.
fn row(frame: &Frame<'_>, colours: &impl Classify, y: u16) -> Vec<f32, MIDDLES> {
    let pairs = frame.row(y).iter().zip((0..).step_by(2));
    middles(pairs.map(|(pair, x)| (x, colours.classify(Pair(*pair).mean()))), 2, widest(frame))
}

/// The middles of white between green, in classes with their places, each `unit` pixels long.
fn middles(classes: impl Iterator<Item = (u16, Colour)>, unit: u16, widest: u16) -> Vec<f32, MIDDLES> {
    let (mut found, mut green, mut white): (Vec<f32, MIDDLES>, _, Option<(u16, u16)>) = (Vec::new(), None, None);
    for (at, class) in classes {
        match (class, white) {
            (Colour::Green, Some((start, end))) => {
                if at - end <= SEAM && end - start <= widest && !found.is_full() {
                    found.extend([0.5 * f32::from(start + end - 1)]);
                }
                (green, white) = (Some(at + unit), None);
            }
            (Colour::Green, None) => green = Some(at + unit),
            (Colour::White, Some((start, _))) => white = Some((start, at + unit)),
            (Colour::White, None) if green.is_some_and(|green| at - green <= SEAM) => white = Some((at, at + unit)),
            _ => {}
        }
    }
    found
}

/// Adds a point to the strand that it continues best, or starts one.
fn string(open: &mut Vec<Strand, OPEN>, point: Vec2, pitch: f32) {
    let fitting = open.iter_mut().filter_map(|strand| Some((strand.miss(point, pitch)?, strand)));
    match fitting.min_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((_, strand)) => strand.add(point),
        // When all places are taken, a strand is long: a new point is worth less.
        None => open.extend([Strand::new(point)].into_iter().take(OPEN - open.len())),
    }
}

/// Ends the strands that were not continued since `before`.
fn close(open: &mut Vec<Strand, OPEN>, axes: Axes, before: f32, lines: &mut Vec<Line, LINES>) {
    open.retain(|strand| {
        let goes_on = strand.last.x >= before;
        if let Some(line) = strand.line(axes).filter(|_| !goes_on) {
            keep(lines, line);
        }
        goes_on
    });
}

fn keep(lines: &mut Vec<Line, LINES>, line: Line) {
    let Err(line) = lines.push(line) else { return };
    let shortest = lines.iter_mut().min_by(|a, b| a.length().total_cmp(&b.length()));
    if let Some(shortest) = shortest.filter(|shortest| shortest.length() < line.length()) {
        *shortest = line;
    }
}
