//! The centre circle, among lines on the ground.
//!
//! In the image the circle comes as short straight pieces. Any two say where the middle is, 0.6 m from both; the place on
//! which most of them agree is the circle's if there is paint all around it. A line through the middle is the halfway line.
//! Cost: each pair of pieces with each piece, and 40 places for each guess: 10 µs for ten pieces.

use core::f32::consts::TAU;

use bica_field::FIELD;
use glam::{Mat2, Vec2};
use heapless::Vec;

use crate::colour::Classify;
use crate::frame::Frame;
use crate::lines::Line;
use crate::paint::{Ground, Shown};
use crate::projection::Camera;

/// How near pieces must be to the circle, m, at a place and for each metre of the way there.
const NEAR: (f32, f32) = (0.04, 0.06);
/// Pieces shorter or longer than this say nothing of the circle, m.
const SHORTEST: f32 = 0.08;
const LONGEST: f32 = 2.0;
/// Pieces that are looked at.
const PIECES: usize = 16;
/// Steps of the fit, and how much it clings to where it is.
const STEPS: usize = 4;
const DAMPING: f32 = 0.02;
/// The pieces must agree along at least this part of the circle, m along it.
const LEAST: f32 = 0.5;
/// Places that are tried, and how far they are apart, m.
const GUESSES: usize = 4;
const NEW: f32 = 0.2;
/// Places on the circle that are looked up, and how many must be painted: at least, and of those that are not hidden.
const PLACES: usize = 40;
const PAINTED: (usize, f32) = (10, 0.75);
/// The halfway line passes the middle this near, m, and is at least so long.
const HALFWAY: (f32, f32) = (0.12, 0.7);

/// The centre circle, on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentreCircle {
    /// Its middle, m, in the frame of the lines it was found among.
    pub centre: Vec2,
    /// The direction of the halfway line, length 1, either way; none if that line is not seen.
    pub halfway: Option<Vec2>,
}

/// Finds the circle by lines on the ground, m in the camera's ground frame.
#[must_use]
pub fn find(frame: &Frame<'_>, colours: &impl Classify, camera: &Camera, lines: &[Line]) -> Option<CentreCircle> {
    let ground = Ground { frame, colours, camera };
    let centre = centres(lines).into_iter().find(|centre| is_painted(&ground, *centre))?;
    Some(CentreCircle { centre, halfway: halfway(lines, centre) })
}

/// Where the middle may be, the place that most pieces agree on first.
fn centres(lines: &[Line]) -> Vec<Vec2, GUESSES> {
    let is_piece = |line: &&Line| (SHORTEST..=LONGEST).contains(&line.length());
    let pieces: Vec<Line, PIECES> = lines.iter().filter(is_piece).take(PIECES).copied().collect();
    let mut centres: Vec<Vec2, GUESSES> = Vec::new();
    while !centres.is_full() {
        let is_new = |centre: &Vec2| centres.iter().all(|other| other.distance(*centre) > NEW);
        let Some(best) = best(&pieces, is_new) else { break };
        let fitted = (0..STEPS).fold(best, |centre, _| nearer(&pieces, centre));
        let _ = centres.push(if fitted.distance(best) < NEW { fitted } else { best });
    }
    centres
}

/// The place that most pieces agree on.
fn best(pieces: &[Line], is_wanted: impl Fn(&Vec2) -> bool) -> Option<Vec2> {
    let pairs =
        pieces.iter().enumerate().flat_map(|(i, a)| pieces[i + 1..].iter().map(move |b| (middle(a), middle(b))));
    let guesses =
        pairs.flat_map(|(a, b)| middles(a, b, FIELD.centre_circle_radius()).into_iter().flatten()).filter(is_wanted);
    let length = |centre: Vec2| pieces.iter().filter(|piece| fits(piece, centre)).map(Line::length).sum::<f32>();
    let (most, best) = guesses.map(|at| (length(at), at)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (most >= LEAST).then_some(best)
}

/// Whether most of a circle is on the carpet, as far as it is in sight.
fn is_painted(ground: &Ground<'_, impl Classify>, centre: Vec2) -> bool {
    let turn = Vec2::from_angle(TAU / PLACES as f32);
    let ways = core::iter::successors(Some(Vec2::X), |way| Some(way.rotate(turn))).take(PLACES);
    let shown = ways.filter_map(|way| ground.shows(centre + FIELD.centre_circle_radius() * way, way));
    let (mut lines, mut all) = (0, 0);
    for shown in shown {
        lines += usize::from(shown == Shown::Line);
        all += usize::from(shown != Shown::Other);
    }
    lines >= PAINTED.0 && lines as f32 >= PAINTED.1 * all as f32
}

fn middle(piece: &Line) -> Vec2 {
    piece.from.midpoint(piece.to)
}

/// The middles of the two circles of a radius through two points, if there are any.
fn middles(a: Vec2, b: Vec2, radius: f32) -> [Option<Vec2>; 2] {
    let half = 0.5 * (b - a);
    let height = libm::sqrtf(radius * radius - half.length_squared());
    let aside = height * half.perp().normalize_or_zero();
    [aside, -aside].map(|aside| Some(a + half + aside).filter(|at| at.is_finite() && half != Vec2::ZERO))
}

fn fits(piece: &Line, centre: Vec2) -> bool {
    let near = |point: Vec2| {
        libm::fabsf(point.distance(centre) - FIELD.centre_circle_radius()) <= NEAR.0 + NEAR.1 * point.length()
    };
    near(piece.from) && near(piece.to) && near(middle(piece))
}

/// The middle that fits the pieces better than this one: a step by least squares. A straight piece through points of an arc
/// is as far from the middle as they are on average, by Simpson's rule.
fn nearer(pieces: &[Line], centre: Vec2) -> Vec2 {
    let (mut normal, mut right) = (Mat2::ZERO, Vec2::ZERO);
    for piece in pieces.iter().filter(|piece| fits(piece, centre)) {
        let ends = [(piece.from, 1.0), (middle(piece), 4.0), (piece.to, 1.0)];
        let off: f32 = ends
            .iter()
            .map(|(point, share)| share * (point.distance(centre) - FIELD.centre_circle_radius()))
            .sum::<f32>()
            / 6.0;
        let outward = (middle(piece) - centre).normalize_or_zero();
        let weight = piece.length() / (NEAR.0 + NEAR.1 * middle(piece).length());
        normal += weight * Mat2::from_cols(outward * outward.x, outward * outward.y);
        right += weight * off * outward;
    }
    // Pieces on one side only leave the other direction open.
    let slack = DAMPING * (normal.x_axis.x + normal.y_axis.y);
    centre + (normal + Mat2::from_diagonal(Vec2::splat(slack))).inverse() * right
}

fn halfway(lines: &[Line], centre: Vec2) -> Option<Vec2> {
    let through = |line: &&Line| {
        let along = (line.to - line.from).normalize_or_zero();
        line.length() >= HALFWAY.1 && libm::fabsf(along.perp_dot(centre - line.from)) <= HALFWAY.0
    };
    let longest = lines.iter().filter(through).max_by(|a, b| a.length().total_cmp(&b.length()))?;
    (longest.to - longest.from).try_normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(centre: Vec2, radius: f32, from: u8, to: u8) -> std::vec::Vec<Line> {
        let at = |step: u8| centre + radius * Vec2::from_angle(f32::from(step) * 0.4);
        (from..to).map(|step| Line { from: at(step), to: at(step + 1) }).collect()
    }

    extern crate std;

    #[test]
    fn pieces_of_half_a_circle_agree_on_its_middle() {
        let centre = Vec2::new(1.5, -0.4);
        let mut lines = arc(centre, FIELD.centre_circle_radius(), 3, 11);
        lines.push(Line { from: centre - Vec2::new(0.9, 0.9), to: centre + Vec2::new(0.2, 0.2) });
        lines.push(Line { from: Vec2::new(0.5, 2.0), to: Vec2::new(3.0, 2.2) });
        let guesses = centres(&lines);
        assert!(guesses.first().is_some_and(|guess| guess.distance(centre) < 0.03), "{guesses:?}");
        assert!(halfway(&lines, guesses[0]).is_some_and(|way| way.perp_dot(Vec2::ONE).abs() < 0.01));
    }

    #[test]
    fn no_pieces_no_middle() {
        let nothing = [Line { from: Vec2::X, to: Vec2::X }, Line { from: Vec2::NAN, to: Vec2::X }];
        assert!(centres(&nothing).is_empty());
    }
}
