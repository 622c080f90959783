//! Points on stripes, strung together from scan to scan as long as they go straight on.

use glam::Vec2;
use heapless::Vec;

use super::ridge::Ridge;
use super::{Axes, Stripe};

/// Strings that are followed at a time.
pub(super) const OPEN: usize = 24;
/// A line with fewer points is none.
const ENOUGH: u16 = 4;
/// The steepest line against its scans; another one is found by the scans of the other way.
const STEEPEST: f32 = 1.2;
/// How far a point may be from where a strand goes on: in the beginning, and when its direction is known, px.
const MISS: (f32, f32) = (1.6, 1.0);

/// Points that go straight on from scan to scan, with the sums for a least squares fit.
#[derive(Clone, Copy)]
pub(super) struct LineTrack {
    first: Vec2,
    last: Vec2,
    slope: f32,
    count: u16,
    sums: [f32; 4],
    width: f32,
    rise: f32,
}

impl LineTrack {
    pub(super) fn new(across: f32, ridge: Ridge) -> Self {
        let first = Vec2::new(across, ridge.at);
        Self { first, last: first, slope: 0.0, count: 1, sums: [0.0; 4], width: ridge.width, rise: ridge.rise }
    }

    /// How far a stripe is from where the strand goes on; none if it is not the next one.
    fn miss(&self, across: f32, ridge: Ridge, pitch: f32) -> Option<f32> {
        let ahead = across - self.last.x;
        let miss = (ridge.at - self.last.y - self.slope * ahead).abs();
        let allowed = match self.count {
            1 => STEEPEST * ahead + 0.5,
            2..=4 => MISS.0,
            _ => MISS.1,
        };
        let alike = ridge.width <= 1.6 * self.width + 2.0 && self.width <= 1.6 * ridge.width + 2.0;
        (alike && ahead > 0.0 && ahead < 2.5 * pitch && miss <= allowed).then_some(miss)
    }

    fn add(&mut self, across: f32, ridge: Ridge) {
        let point = Vec2::new(across, ridge.at);
        let offset = point - self.first;
        let terms = [offset.x, offset.y, offset.x * offset.x, offset.x * offset.y];
        self.sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        self.count += 1;
        self.last = point;
        self.slope = self.fitted().0;
        let part = (1.0 / f32::from(self.count)).max(0.1);
        self.width += part * (ridge.width - self.width);
        self.rise += part * (ridge.rise - self.rise);
    }

    /// Slope and offset of the fitted line, from the first point on.
    fn fitted(&self) -> (f32, f32) {
        let (n, [x, y, xx, xy]) = (f32::from(self.count), self.sums);
        let slope = (n * xy - x * y) / (n * xx - x * x).max(1e-3);
        (slope, (y - slope * x) / n)
    }

    /// The fitted stripe, if it is long enough and not too steep.
    pub(super) fn stripe(&self, axes: Axes) -> Option<Stripe> {
        let (slope, offset) = self.fitted();
        let at = |across: f32| axes.pixel(across, self.first.y + offset + slope * (across - self.first.x));
        let width = self.width / libm::sqrtf(1.0 + slope * slope);
        let is_line = self.count >= ENOUGH && slope.abs() <= STEEPEST;
        is_line.then(|| Stripe { from: at(self.first.x), to: at(self.last.x), width, rise: self.rise })
    }
}

/// Adds a stripe to the strand that it continues best, or starts one.
pub(super) fn string(open: &mut Vec<LineTrack, OPEN>, across: f32, ridge: Ridge, pitch: f32) {
    let fitting = open.iter_mut().filter_map(|strand| Some((strand.miss(across, ridge, pitch)?, strand)));
    match fitting.min_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((_, strand)) => strand.add(across, ridge),
        // When all places are taken, a strand is long: a new point is worth less.
        None => open.extend([LineTrack::new(across, ridge)].into_iter().take(OPEN - open.len())),
    }
}

/// Ends the strands that were not continued since `before` and hands over their stripes.
pub(super) fn close(open: &mut Vec<LineTrack, OPEN>, axes: Axes, before: f32, mut hand: impl FnMut(Stripe)) {
    open.retain(|strand| {
        let goes_on = strand.last.x >= before;
        if !goes_on {
            strand.stripe(axes).into_iter().for_each(&mut hand);
        }
        goes_on
    });
}
