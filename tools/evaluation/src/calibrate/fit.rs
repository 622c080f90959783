//! Thresholds from samples by coordinate ascent: each bound in turn moves to the best F3 score.
//!
//! F3 weighs recall nine times as much as precision: detectors reject false pixels by the shape of their region, but
//! cannot recover missed ones. If a range of bounds has the same score, its middle is chosen. If no other class is
//! near, the bound keeps a margin for other illumination.

use bica_vision::colour::{Colour, Filter};
use bica_vision::frame::Pixel;

/// Largest number of passes over the bounds.
const ROUNDS: usize = 12;
/// Difference of F3 that counts as equal.
const SAME_SCORE: f64 = 0.0005;
/// Weight of recall relative to precision.
const RECALL_WEIGHT: f64 = 9.0;
/// Fraction of a class that is outside the initial bounds at each end.
const INITIAL_OUTSIDE: f64 = 0.01;

/// Sample in the coordinates of the bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    /// Hue (degrees from the mean of the class), saturation (percent), luma, chroma.
    values: [f32; 4],
    /// Weight if the sample is of the class, else 0.
    good: f64,
    /// Weight if the sample is of another class, else 0.
    bad: f64,
}

/// Coordinates of a class: hue is relative to its mean.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axes {
    middle: f32,
}

/// One side of the range of a quantity.
#[derive(Clone, Copy, Debug)]
struct Bound {
    /// Index of the quantity.
    value: usize,
    /// Whether this is the upper bound.
    is_upper: bool,
    /// Largest distance from the class, as a function of the end of the class.
    margin: fn(i32) -> i32,
}

/// Range of each quantity; saturation is clipped at 400 %.
const LIMITS: [(i32, i32); 4] = [(-89, 89), (0, 400), (0, 255), (0, 181)];

/// Bounds of a coloured class. The margins of luma and chroma are wide because they vary with exposure.
const BOUNDS: [Bound; 6] = [
    Bound { value: 0, is_upper: false, margin: |_| 10 },
    Bound { value: 0, is_upper: true, margin: |_| 10 },
    Bound { value: 1, is_upper: false, margin: |edge| edge / 3 },
    Bound { value: 3, is_upper: false, margin: |edge| edge / 3 },
    Bound { value: 2, is_upper: false, margin: |edge| edge / 3 },
    Bound { value: 2, is_upper: true, margin: |edge| edge / 3 },
];

/// Bounds of white: low saturation, high luma.
const BOUNDS_OF_WHITE: [Bound; 2] = [
    Bound { value: 1, is_upper: true, margin: |edge| edge / 3 },
    Bound { value: 2, is_upper: false, margin: |edge| edge / 3 },
];

/// Thresholds as ranges of the quantities.
type Box4 = [(i32, i32); 4];

impl Axes {
    /// Coordinates relative to the mean chroma of the samples of a class.
    pub(super) fn of(class: impl Iterator<Item = (Pixel, f32)>) -> Self {
        let mean = class.fold((0.0, 0.0), |(b, r), (pixel, weight)| {
            (b + weight * (f32::from(pixel.cb) - 128.0), r + weight * (f32::from(pixel.cr) - 128.0))
        });
        Self { middle: mean.1.atan2(mean.0).to_degrees().round() }
    }

    /// Converts a sample.
    pub(super) fn point(self, pixel: Pixel, weight: f32, is_of_class: bool) -> Point {
        let (b, r) = (f32::from(pixel.cb) - 128.0, f32::from(pixel.cr) - 128.0);
        let chroma = b.hypot(r);
        let hue = (r.atan2(b).to_degrees() - self.middle + 540.0).rem_euclid(360.0) - 180.0;
        let saturation = (100.0 * chroma / f32::from(pixel.y).max(1.0)).min(400.0);
        let weight = f64::from(weight);
        let (good, bad) = if is_of_class { (weight, 0.0) } else { (0.0, weight) };
        Point { values: [hue, saturation, f32::from(pixel.y), chroma], good, bad }
    }
}

/// Returns the best thresholds of a class; `None` without a point of the class.
pub(super) fn fit(class: Colour, axes: Axes, points: &[Point]) -> Option<Filter> {
    let bounds: &[Bound] = if class == Colour::White { &BOUNDS_OF_WHITE } else { &BOUNDS };
    let first = start(bounds, points)?;
    let mut ranges = first;
    for _ in 0..ROUNDS {
        let before = ranges;
        for bound in bounds {
            bound.improve(&mut ranges, &first, points);
        }
        if ranges == before {
            break;
        }
    }
    Some(filter(class, axes, &ranges))
}

/// Initial ranges, which contain nearly all points of the class.
fn start(bounds: &[Bound], points: &[Point]) -> Option<Box4> {
    let total: f64 = points.iter().map(|point| point.good).sum();
    let mut ranges = LIMITS;
    for bound in bounds {
        let mut values: Vec<_> =
            points.iter().filter(|point| point.good > 0.0).map(|p| (p.values[bound.value], p.good)).collect();
        values.sort_by(|a, b| a.0.total_cmp(&b.0));
        if bound.is_upper {
            values.reverse();
        }
        let mut outside = 0.0;
        let inner = values.iter().find(|(_, weight)| {
            outside += weight;
            outside > INITIAL_OUTSIDE * total
        });
        bound.set(&mut ranges, bound.round(inner?.0));
    }
    Some(ranges)
}

impl Bound {
    /// Tightest integer bound that accepts a value.
    fn round(self, value: f32) -> i32 {
        if self.is_upper { value.ceil() as i32 } else { value.floor() as i32 }
    }

    fn get(self, ranges: &Box4) -> i32 {
        if self.is_upper { ranges[self.value].1 } else { ranges[self.value].0 }
    }

    fn set(self, ranges: &mut Box4, to: i32) {
        let side = &mut ranges[self.value];
        *(if self.is_upper { &mut side.1 } else { &mut side.0 }) = to;
    }

    /// Moves the bound to the middle of the range with the best F3, with the other bounds fixed.
    fn improve(self, ranges: &mut Box4, first: &Box4, points: &[Point]) {
        let (low, high) = LIMITS[self.value];
        let mut open = *ranges;
        self.set(&mut open, if self.is_upper { high } else { low });
        // Weight by the tightness that rejects a point: a suffix sum gives the weight that each bound accepts.
        let tightness = |at: i32| (if self.is_upper { high - at } else { at - low }) as usize;
        let mut passing = vec![(0.0, 0.0); (high - low) as usize + 1];
        let mut missed = 0.0;
        for point in points {
            if is_inside(&open, point) {
                let at = self.round(point.values[self.value]).clamp(low, high);
                let (good, bad) = &mut passing[tightness(at)];
                (*good, *bad) = (*good + point.good, *bad + point.bad);
            } else {
                missed += point.good;
            }
        }
        let total = missed + passing.iter().map(|(good, _)| good).sum::<f64>();
        let (mut good, mut bad) = (0.0, 0.0);
        let mut scores: Vec<f64> = passing
            .iter()
            .rev()
            .map(|(more_good, more_bad)| {
                (good, bad) = (good + more_good, bad + more_bad);
                (1.0 + RECALL_WEIGHT) * good / (RECALL_WEIGHT * total + good + bad).max(1e-9)
            })
            .collect();
        scores.reverse();
        let edge = self.get(first);
        let loosest = tightness(edge).saturating_sub((self.margin)(edge) as usize);
        let best = scores[loosest..].iter().copied().fold(0.0, f64::max);
        let is_best = |place: &usize| scores[*place] >= best - SAME_SCORE;
        let Some(from) = (loosest..scores.len()).find(is_best) else { return };
        let to = (from..scores.len()).take_while(is_best).last().unwrap_or(from);
        let place = if from == loosest { from } else { usize::midpoint(from, to) } as i32;
        self.set(ranges, if self.is_upper { high - place } else { low + place });
    }
}

fn is_inside(ranges: &Box4, point: &Point) -> bool {
    point.values.iter().zip(ranges).all(|(value, (low, high))| (*low as f32..=*high as f32).contains(value))
}

fn filter(class: Colour, axes: Axes, ranges: &Box4) -> Filter {
    let [hue, saturation, luma, chroma] = *ranges;
    let filter = Filter::ANY.luma(luma.0 as u8, luma.1 as u8).chroma(chroma.0 as u8);
    let filter = filter.saturation(saturation.0 as u16, saturation.1 as u16);
    let middle = axes.middle as i32;
    if class == Colour::White {
        return filter;
    }
    filter.hue((middle + hue.0).rem_euclid(360) as i16, (middle + hue.1).rem_euclid(360) as i16)
}
