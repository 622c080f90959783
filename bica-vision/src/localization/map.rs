//! The lines and crossings of the whole field.

use core::f32::consts::PI;

use bica_field::{Crossing, CrossingKind, FIELD};
use bica_motion::pose::Pose2;
use glam::Vec2;

use super::approximate;

/// Half of the field's crossings; a turn of 180° gives the others.
pub(super) const HALF: [Crossing; 8] = FIELD.half_crossings();
/// Distance from the halfway line, m, that divides the lines. At smaller distances the nearest line is never one of the
/// penalty area, at larger distances never the circle or the halfway line.
const DIVIDE: f32 = 1.3;

/// Number of the field's crossings of a kind.
#[must_use]
pub fn count(kind: CrossingKind) -> usize {
    2 * HALF.iter().filter(|crossing| crossing.kind == kind).count()
}

/// Poses of the field's crossings of a kind, field frame, with the heading of [`Crossing`].
pub fn crossings(kind: CrossingKind) -> impl Iterator<Item = Pose2> {
    let half_turn = Pose2::new(0.0, 0.0, PI);
    let of_kind = HALF.iter().filter(move |crossing| crossing.kind == kind);
    of_kind.flat_map(move |&Crossing { position, heading, .. }| {
        let pose = Pose2 { position, heading };
        [pose, half_turn * pose]
    })
}

/// Square of the distance from a point to the centre of the nearest line, m².
///
/// It agrees with [`line_distance`](bica_field::FieldDimensions::line_distance) within 0.1 mm, but compares only the
/// candidates for the nearest line: a tenth of the instructions.
#[inline]
pub(super) fn line_distance_squared(point: Vec2) -> f32 {
    let (corner, area, post) = (FIELD.field_corner(), FIELD.penalty_area_corner(), FIELD.goal_post());
    let Vec2 { x, y } = point.abs();
    let to_side_line = square(y - corner.y);
    let outside = square(positive(y - corner.y));
    if x < DIVIDE {
        let to_halfway_line = square(x) + outside;
        let to_circle = square(approximate::sqrt(square(x) + square(y)) - FIELD.centre_circle_radius());
        return least(least(to_side_line, to_halfway_line), least(to_mark(x, y), to_circle));
    }
    let to_goal_line = square(x - corner.x) + outside;
    if x < corner.x {
        let to_area_front = square(x - area.x) + square(positive(y - area.y));
        let to_area_side = square(y - area.y) + square(positive(area.x - x));
        let to_area = least(to_area_front, to_area_side);
        return least(least(to_side_line, to_goal_line), least(to_area, to_mark(x, y)));
    }
    let to_corners = square(x - corner.x) + least(to_side_line, square(y - area.y));
    let to_goal_back = square(x - FIELD.goal_back()) + square(positive(y - post.y));
    let beyond = positive(post.x - x) + positive(x - FIELD.goal_back());
    let to_goal_side = square(y - post.y) + square(beyond);
    least(least(to_corners, to_goal_line), least(to_goal_back, to_goal_side))
}

/// Square of the distance to the nearest penalty mark, m².
const fn to_mark(x: f32, y: f32) -> f32 {
    square(x - FIELD.penalty_mark()) + square(y)
}

/// The smaller of two numbers. `f32::min` takes several more instructions, because it handles NaN.
#[inline(always)]
pub(super) const fn least(one: f32, other: f32) -> f32 {
    if one < other { one } else { other }
}

#[inline(always)]
const fn positive(value: f32) -> f32 {
    if value > 0.0 { value } else { 0.0 }
}

#[inline(always)]
const fn square(value: f32) -> f32 {
    value * value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_line_equals_exhaustive_search() {
        for (x, y) in (-420..=420_i16).flat_map(|x| (-320..=320_i16).map(move |y| (x, y))) {
            let point = Vec2::new(f32::from(x), f32::from(y)) / 100.0;
            let (fast, exact) = (libm::sqrtf(line_distance_squared(point)), FIELD.line_distance(point));
            assert!((fast - exact).abs() < 1e-4, "{fast} instead of {exact} m at {point}");
        }
    }
}
