//! Line segments in the making: measured, merged and limited in number.

use glam::Vec2;
use heapless::Vec;

/// Maximum number of segments in a frame. Of more, the shortest are dropped.
pub const LINES: usize = 32;

/// Scan direction: `along` counts within a scan, `across` from scan to scan.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Axes {
    Columns,
    Rows,
}

impl Axes {
    pub(super) fn pixel(self, across: f32, along: f32) -> Vec2 {
        if self == Self::Columns { Vec2::new(across, along) } else { Vec2::new(along, across) }
    }
}

/// Line segment with the appearance of its pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stripe {
    pub(super) from: Vec2,
    pub(super) to: Vec2,
    /// Width across the line, px.
    pub(super) width: f32,
    /// Luma contrast to the carpet, 0 to 255.
    pub(super) rise: f32,
}

impl Stripe {
    fn length(&self) -> f32 {
        self.from.distance(self.to)
    }
}

/// Segments in the making.
pub(super) type Stripes = Vec<Stripe, LINES>;

/// Merges segments of one line: ends within `apart` px of the longer segment's line and at most `between` px beyond its ends.
pub(super) fn join(lines: &mut Stripes, apart: f32, between: f32) {
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
    // Where another line crosses, a gap of that line's width remains.
    let between = between.min(0.8 * short.length());
    let meets = low.0 <= length + between && high.0 >= -between;
    let first = if low.0 < 0.0 { low.1 } else { long.from };
    let last = if high.0 > length { high.1 } else { long.to };
    meets.then_some(Stripe { from: first, to: last, ..*long })
}

/// Adds a segment. A full list keeps the longest segments.
pub(super) fn keep(stripes: &mut Stripes, stripe: Stripe) {
    let Err(stripe) = stripes.push(stripe) else { return };
    let shortest = stripes.iter_mut().min_by(|a, b| a.length().total_cmp(&b.length()));
    if let Some(shortest) = shortest.filter(|shortest| shortest.length() < stripe.length()) {
        *shortest = stripe;
    }
}
