//! Detection of the centre circle among lines on the ground.
//!
//! In the image the circle appears as short straight segments. Two of them give two hypotheses for its centre. The
//! hypothesis with the most support is refined by least squares and accepted if the image shows a line all around it. A
//! line through the centre is the halfway line.
//!
//! Cost: each pair of segments against each segment, and up to 40 samples for each hypothesis: 10 µs for ten segments. The next
//! hypothesis is searched only if the image contradicts the one before.

use core::f32::consts::TAU;

use bica_field::FIELD;
use glam::{Mat2, Vec2};
use heapless::Vec;

use crate::colour::Classify;
use crate::frame::Frame;
use crate::line_probe::{Ground, Surface};
use crate::lines::Line;
use crate::markings::MarkingDetection;
use crate::projection::Camera;

/// Tolerated distance of a segment from the circle at the robot, m.
const TOLERANCE: f32 = 0.04;
/// Growth of the tolerance per metre of distance.
const TOLERANCE_PER_METRE: f32 = 0.06;
/// Minimum length of a segment used, m.
const SHORTEST: f32 = 0.08;
/// Maximum length of a segment used, m.
const LONGEST: f32 = 2.0;
/// Maximum number of segments used.
const PIECES: usize = 16;
/// Number of Gauss–Newton steps.
const STEPS: usize = 4;
/// Damping of a step, relative to the trace of the normal matrix.
const DAMPING: f32 = 0.02;
/// Maximum number of hypotheses.
const HYPOTHESES: usize = 4;
/// Minimum distance between hypotheses, m.
const NEW: f32 = 0.2;
/// Number of samples on the circle.
const SAMPLES: usize = 40;
/// Minimum number of samples on a line.
const ON_LINE: usize = 10;
/// Maximum distance of the halfway line from the centre, m.
const HALFWAY_DISTANCE: f32 = 0.12;
/// Minimum length of the halfway line, m.
const HALFWAY_LENGTH: f32 = 0.7;

/// Centre circle on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentreCircle {
    /// Centre, m, in the frame of the lines.
    pub centre: Vec2,
    /// Direction of the halfway line, unit vector of either sign; `None` if that line is not visible.
    pub halfway: Option<Vec2>,
}

/// Finds the circle among lines on the ground, m, camera's ground frame.
#[must_use]
pub fn find(
    frame: &Frame<'_>,
    colours: &impl Classify,
    camera: &Camera,
    lines: &[Line],
    tuning: &MarkingDetection,
) -> Option<CentreCircle> {
    let ground = Ground { frame, colours, camera };
    let centre = centres(lines, tuning.min_circle_length)
        .find(|centre| is_on_line(&ground, *centre, tuning.min_circle_share))?;
    Some(CentreCircle { centre, halfway: halfway(lines, centre) })
}

/// Hypotheses for the centre, the one with the most support first.
fn centres(lines: &[Line], min_length: f32) -> impl Iterator<Item = Vec2> + use<> {
    let is_piece = |piece: &Piece| (SHORTEST..=LONGEST).contains(&piece.length);
    let pieces: Vec<Piece, PIECES> = lines.iter().map(Piece::of).filter(is_piece).take(PIECES).collect();
    let mut centres: Vec<Vec2, HYPOTHESES> = Vec::new();
    core::iter::from_fn(move || {
        if centres.is_full() {
            return None;
        }
        let is_new = |centre: &Vec2| centres.iter().all(|other| other.distance(*centre) > NEW);
        let best = best(&pieces, min_length, is_new)?;
        let fitted = (0..STEPS).fold(best, |centre, _| nearer(&pieces, centre));
        centres.extend([if fitted.distance(best) < NEW { fitted } else { best }]);
        centres.last().copied()
    })
}

/// Segment that may be a part of the circle.
struct Piece {
    /// One end, the middle and the other end, each with its tolerated distance from the circle, m.
    points: [(Vec2, f32); 3],
    length: f32,
}

impl Piece {
    fn of(line: &Line) -> Self {
        let points = [line.from, line.from.midpoint(line.to), line.to];
        Self { points: points.map(|at| (at, TOLERANCE + TOLERANCE_PER_METRE * at.length())), length: line.length() }
    }

    const fn middle(&self) -> Vec2 {
        self.points[1].0
    }

    /// Whether the segment is on the circle with a centre.
    fn fits(&self, centre: Vec2) -> bool {
        let is_near = |(point, tolerance): &(Vec2, f32)| {
            libm::fabsf(point.distance(centre) - FIELD.centre_circle_radius()) <= *tolerance
        };
        self.points.iter().all(is_near)
    }
}

/// Hypothesis with the most support.
fn best(pieces: &[Piece], min_length: f32, matches: impl Fn(&Vec2) -> bool) -> Option<Vec2> {
    let pairs =
        pieces.iter().enumerate().flat_map(|(i, a)| pieces[i + 1..].iter().map(move |b| (a.middle(), b.middle())));
    let hypotheses =
        pairs.flat_map(|(a, b)| middles(a, b, FIELD.centre_circle_radius()).into_iter().flatten()).filter(matches);
    let length = |centre: Vec2| pieces.iter().filter(|piece| piece.fits(centre)).map(|piece| piece.length).sum::<f32>();
    let (most, best) = hypotheses.map(|at| (length(at), at)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (most >= min_length).then_some(best)
}

/// Whether the image shows a line along most of the visible part of the circle.
fn is_on_line(ground: &Ground<'_, impl Classify>, centre: Vec2, min_share: f32) -> bool {
    let turn = Vec2::from_angle(TAU / SAMPLES as f32);
    let ways = core::iter::successors(Some(Vec2::X), |way| Some(way.rotate(turn))).take(SAMPLES);
    let shown = ways.filter_map(|way| ground.surface(centre + FIELD.centre_circle_radius() * way, way));
    let (mut lines, mut carpets) = (0, 0);
    for shown in shown {
        lines += usize::from(shown == Surface::Line);
        carpets += usize::from(shown == Surface::Carpet);
        // Even if all other samples were on a line, they would be too few.
        if ((SAMPLES - carpets) as f32) < min_share * SAMPLES as f32 {
            return false;
        }
    }
    lines >= ON_LINE && lines as f32 >= min_share * (lines + carpets) as f32
}

/// Centres of the two circles of a radius through two points, if there are any.
fn middles(a: Vec2, b: Vec2, radius: f32) -> [Option<Vec2>; 2] {
    let half = 0.5 * (b - a);
    let height = libm::sqrtf(radius * radius - half.length_squared());
    let aside = height * half.perp().normalize_or_zero();
    [aside, -aside].map(|aside| Some(a + half + aside).filter(|at| at.is_finite() && half != Vec2::ZERO))
}

/// Returns the refined centre after one Gauss–Newton step. The mean distance of a chord's points from the centre
/// follows from Simpson's rule.
fn nearer(pieces: &[Piece], centre: Vec2) -> Vec2 {
    let (mut normal, mut right) = (Mat2::ZERO, Vec2::ZERO);
    for piece in pieces.iter().filter(|piece| piece.fits(centre)) {
        let shares = [1.0, 4.0, 1.0].into_iter().zip(&piece.points);
        let off: f32 =
            shares.map(|(share, (at, _))| share * (at.distance(centre) - FIELD.centre_circle_radius())).sum::<f32>()
                / 6.0;
        let (middle, tolerance) = piece.points[1];
        let outward = (middle - centre).normalize_or_zero();
        let weight = piece.length / tolerance;
        normal += weight * Mat2::from_cols(outward * outward.x, outward * outward.y);
        right += weight * off * outward;
    }
    // Segments on one side only do not constrain the other direction.
    let slack = DAMPING * (normal.x_axis.x + normal.y_axis.y);
    centre + (normal + Mat2::from_diagonal(Vec2::splat(slack))).inverse() * right
}

fn halfway(lines: &[Line], centre: Vec2) -> Option<Vec2> {
    let through = |line: &&Line| {
        let along = (line.to - line.from).normalize_or_zero();
        line.length() >= HALFWAY_LENGTH && libm::fabsf(along.perp_dot(centre - line.from)) <= HALFWAY_DISTANCE
    };
    let longest = lines.iter().filter(through).max_by(|a, b| a.length().total_cmp(&b.length()))?;
    (longest.to - longest.from).try_normalize()
}

#[cfg(test)]
mod tests {
    use bica_core::Params;

    use super::*;

    fn arc(centre: Vec2, radius: f32, from: u8, to: u8) -> std::vec::Vec<Line> {
        let at = |step: u8| centre + radius * Vec2::from_angle(f32::from(step) * 0.4);
        (from..to).map(|step| Line { from: at(step), to: at(step + 1) }).collect()
    }

    extern crate std;

    #[test]
    fn segments_of_half_circle_give_its_centre() {
        let centre = Vec2::new(1.5, -0.4);
        let mut lines = arc(centre, FIELD.centre_circle_radius(), 3, 11);
        lines.push(Line { from: centre - Vec2::new(0.9, 0.9), to: centre + Vec2::new(0.2, 0.2) });
        lines.push(Line { from: Vec2::new(0.5, 2.0), to: Vec2::new(3.0, 2.2) });
        let hypothesis = centres(&lines, MarkingDetection::DEFAULT.min_circle_length).next().expect("a hypothesis");
        assert!(hypothesis.distance(centre) < 0.03, "{hypothesis:?}");
        assert!(halfway(&lines, hypothesis).is_some_and(|way| way.perp_dot(Vec2::ONE).abs() < 0.01));
    }

    #[test]
    fn degenerate_segments_give_no_centre() {
        let degenerate = [Line { from: Vec2::X, to: Vec2::X }, Line { from: Vec2::NAN, to: Vec2::X }];
        assert_eq!(centres(&degenerate, MarkingDetection::DEFAULT.min_circle_length).next(), None);
    }
}
