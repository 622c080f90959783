//! The centre circle, among lines on the ground.
//!
//! In the image the circle comes as short straight pieces. Each piece says where the middle is, 0.6 m to one of its
//! sides; the place on which most of them agree is the circle's. A line through the middle is the halfway line.
//! Cost: each pair of pieces twice, 1 µs for ten.

use glam::Vec2;

use crate::lines::Line;
use crate::pitch::CIRCLE;

/// How near pieces must be to the circle, m, at a place and for each metre of the way there.
const NEAR: (f32, f32) = (0.04, 0.03);
/// Pieces longer than this do not belong to the circle, m.
const LONGEST: f32 = 0.95;
/// The pieces must be seen around at least this part of the circle, m along it.
const LEAST: f32 = 1.2;
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

/// Finds the circle among lines on the ground, m, with the robot near the origin.
#[must_use]
pub fn among(lines: &[Line]) -> Option<CentreCircle> {
    let pieces = || lines.iter().filter(|piece| piece.length() <= LONGEST);
    let guesses = pieces().flat_map(|piece| middles(piece).into_iter().flatten());
    let length = |centre: Vec2| pieces().filter(|piece| fits(piece, centre)).map(Line::length).sum::<f32>();
    let best = guesses.max_by(|a, b| length(*a).total_cmp(&length(*b))).filter(|centre| length(*centre) >= LEAST)?;
    let (mut sum, mut weight) = (Vec2::ZERO, 0.0);
    for piece in pieces().filter(|piece| fits(piece, best)) {
        for middle in middles(piece).into_iter().flatten().filter(|middle| middle.distance(best) < 0.3) {
            sum += piece.length() * middle;
            weight += piece.length();
        }
    }
    let centre = sum / weight;
    centre.is_finite().then(|| CentreCircle { centre, halfway: halfway(lines, centre) })
}

/// The middles of the two circles that a piece may be of.
fn middles(piece: &Line) -> [Option<Vec2>; 2] {
    let half = 0.5 * piece.length();
    // The chord's points lie inside the circle, on average by a third of the arc's height.
    let height = libm::sqrtf((CIRCLE * CIRCLE - half * half).max(0.0));
    let mean = height + (CIRCLE - height) / 3.0;
    let normal = (piece.to - piece.from).perp().normalize_or_zero();
    let middle = 0.5 * (piece.from + piece.to);
    [1.0, -1.0].map(|side| Some(middle + side * mean * normal).filter(|at| at.is_finite() && normal != Vec2::ZERO))
}

fn fits(piece: &Line, centre: Vec2) -> bool {
    let near = |point: Vec2| libm::fabsf(point.distance(centre) - CIRCLE) <= NEAR.0 + NEAR.1 * point.length();
    near(piece.from) && near(piece.to) && near(0.5 * (piece.from + piece.to))
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
    fn half_a_circle_and_the_halfway_line_are_enough() {
        let centre = Vec2::new(1.5, -0.4);
        let mut lines = arc(centre, CIRCLE, 3, 11);
        lines.push(Line { from: centre - Vec2::new(0.9, 0.9), to: centre + Vec2::new(0.2, 0.2) });
        lines.push(Line { from: Vec2::new(0.5, 2.0), to: Vec2::new(3.0, 2.2) });
        let found = among(&lines).expect("a circle");
        assert!(found.centre.distance(centre) < 0.02, "{found:?}");
        assert!(found.halfway.is_some_and(|way| way.perp_dot(Vec2::ONE).abs() < 0.01), "{found:?}");
    }

    #[test]
    fn other_lines_are_no_circle() {
        let centre = Vec2::new(1.5, -0.4);
        assert_eq!(among(&arc(centre, 0.9, 3, 11)), None);
        assert_eq!(among(&arc(centre, CIRCLE, 3, 6)), None);
        let corner = [Line { from: Vec2::X, to: Vec2::new(1.6, 0.0) }, Line { from: Vec2::X, to: Vec2::new(1.0, 0.9) }];
        assert_eq!(among(&corner), None);
        assert_eq!(among(&[Line { from: Vec2::X, to: Vec2::X }, Line { from: Vec2::NAN, to: Vec2::X }]), None);
    }
}
