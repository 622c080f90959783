//! Tracks of ridges that continue straight from scan to scan.

use glam::Vec2;
use heapless::Vec;

use super::ridge::Ridge;
use super::stripe::{Axes, Stripe};

/// Maximum number of open tracks.
pub(super) const OPEN: usize = 24;
/// Minimum number of points of a line.
const ENOUGH: u16 = 4;
/// Maximum slope against the scan normal; steeper lines are found by the scans of the other direction.
const STEEPEST: f32 = 1.2;
/// Maximum distance of a point from a short track, whose direction is uncertain, px.
const NEW_DISTANCE: f32 = 1.6;
/// Maximum distance of a point from a track, px.
const DISTANCE: f32 = 1.0;

/// Points that continue straight from scan to scan, with the sums of a least-squares fit.
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

    /// Distance of a ridge from the extrapolated track; `None` if the ridge does not continue it.
    fn distance(&self, across: f32, ridge: Ridge, pitch: f32) -> Option<f32> {
        let ahead = across - self.last.x;
        let miss = (ridge.at - self.last.y - self.slope * ahead).abs();
        let allowed = match self.count {
            1 => STEEPEST * ahead + 0.5,
            2..=4 => NEW_DISTANCE,
            _ => DISTANCE,
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

    /// Slope and offset of the fitted line, relative to the first point.
    fn fitted(&self) -> (f32, f32) {
        let (n, [x, y, xx, xy]) = (f32::from(self.count), self.sums);
        let slope = (n * xy - x * y) / (n * xx - x * x).max(1e-3);
        (slope, (y - slope * x) / n)
    }

    /// Fitted line segment, if it has enough points and is not too steep.
    pub(super) fn stripe(&self, axes: Axes) -> Option<Stripe> {
        let (slope, offset) = self.fitted();
        let at = |across: f32| axes.pixel(across, self.first.y + offset + slope * (across - self.first.x));
        let width = self.width / libm::sqrtf(1.0 + slope * slope);
        let is_line = self.count >= ENOUGH && slope.abs() <= STEEPEST;
        is_line.then(|| Stripe { from: at(self.first.x), to: at(self.last.x), width, rise: self.rise })
    }
}

/// Appends a ridge to the track that it continues best, or starts a track.
pub(super) fn append(open: &mut Vec<LineTrack, OPEN>, across: f32, ridge: Ridge, pitch: f32) {
    let fitting = open.iter_mut().filter_map(|track| Some((track.distance(across, ridge, pitch)?, track)));
    match fitting.min_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((_, track)) => track.add(across, ridge),
        // A full list contains long tracks, which are worth more than a new point.
        None => open.extend([LineTrack::new(across, ridge)].into_iter().take(OPEN - open.len())),
    }
}

/// Closes the tracks without a point since `before` and emits their segments.
pub(super) fn close(open: &mut Vec<LineTrack, OPEN>, axes: Axes, before: f32, mut emit: impl FnMut(Stripe)) {
    open.retain(|track| {
        let is_open = track.last.x >= before;
        if !is_open {
            track.stripe(axes).into_iter().for_each(&mut emit);
        }
        is_open
    });
}
