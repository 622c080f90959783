//! The field of 2009 as a map: its lines, their crossings, its goal posts.
//!
//! Field frame: origin on the centre mark, x towards the goal that is attacked, y to the left, metres. Lengths: rules of
//! the Standard Platform League 2009, middles of lines and posts. Turned by half a turn the field is the same but for the
//! colours of its goals.

use bica_motion::bounds::clamp;
use core::f32::consts::{FRAC_PI_2, PI};

use bica_motion::pose::Pose2;
use glam::Vec2;

use crate::crossings::CrossingKind;

/// The carpet's corner.
pub const CARPET: Vec2 = Vec2::new(3.7, 2.7);
/// The corner of the lines around the field.
pub const CORNER: Vec2 = Vec2::new(3.0, 2.0);
/// The corner of a penalty area that is nearest to the centre mark's line.
pub const PENALTY_AREA: Vec2 = Vec2::new(2.4, 1.5);
/// The radius of the centre circle.
pub const CIRCLE: f32 = 0.6;
/// Where the penalty mark is, on the x axis.
pub const PENALTY_MARK: f32 = 1.2;
/// The left post of the attacked goal.
pub const POST: Vec2 = Vec2::new(3.05, 0.7);

/// The posts of a goal, the left one first as seen from the field.
#[must_use]
pub const fn posts(attacked: bool) -> [Vec2; 2] {
    let (x, y) = if attacked { (POST.x, POST.y) } else { (-POST.x, -POST.y) };
    [Vec2::new(x, y), Vec2::new(x, -y)]
}

/// The x of the back of the attacked goal.
pub const GOAL_BACK: f32 = 3.5;

/// How far a place is from the middle of the nearest line, m; the white frame of a goal on the ground counts too. Not a
/// number for what is none. Cost: 10 ns.
#[must_use]
pub fn line_distance(place: Vec2) -> f32 {
    let at = place.abs();
    // Each line of the quarter: where it starts, along x or y, and how long it is.
    let level = |y: f32, from: f32, to: f32| (at - Vec2::new(clamp(at.x, from, to), y)).length_squared();
    let upright = |x: f32, to: f32| (at - Vec2::new(x, at.y.min(to))).length_squared();
    let straight = level(CORNER.y, 0.0, CORNER.x)
        .min(upright(CORNER.x, CORNER.y))
        .min(level(PENALTY_AREA.y, PENALTY_AREA.x, CORNER.x))
        .min(upright(PENALTY_AREA.x, PENALTY_AREA.y))
        .min(upright(0.0, CORNER.y))
        .min(upright(GOAL_BACK, POST.y))
        .min(level(POST.y, POST.x, GOAL_BACK))
        .min(at.distance_squared(Vec2::new(PENALTY_MARK, 0.0)));
    libm::sqrtf(straight).min(libm::fabsf(at.length() - CIRCLE))
}

/// The crossings in one half; half a turn gives the others. Headings as of [`Crossing`](crate::crossings::Crossing).
const HALF: [(CrossingKind, Pose2); 8] = [
    (CrossingKind::L, Pose2::new(CORNER.x, CORNER.y, PI)),
    (CrossingKind::L, Pose2::new(CORNER.x, -CORNER.y, FRAC_PI_2)),
    (CrossingKind::L, Pose2::new(PENALTY_AREA.x, PENALTY_AREA.y, -FRAC_PI_2)),
    (CrossingKind::L, Pose2::new(PENALTY_AREA.x, -PENALTY_AREA.y, 0.0)),
    (CrossingKind::T, Pose2::new(CORNER.x, PENALTY_AREA.y, PI)),
    (CrossingKind::T, Pose2::new(CORNER.x, -PENALTY_AREA.y, PI)),
    (CrossingKind::T, Pose2::new(0.0, CORNER.y, -FRAC_PI_2)),
    (CrossingKind::X, Pose2::new(0.0, CIRCLE, 0.0)),
];

/// How many crossings of a kind there are.
#[must_use]
pub fn count(kind: CrossingKind) -> usize {
    2 * HALF.iter().filter(|crossing| crossing.0 == kind).count()
}

/// The crossings of a kind, with the heading of [`Crossing`](crate::crossings::Crossing).
pub fn crossings(kind: CrossingKind) -> impl Iterator<Item = Pose2> {
    let half_turn = Pose2::new(0.0, 0.0, PI);
    let of_kind = HALF.iter().filter(move |crossing| crossing.0 == kind);
    of_kind.flat_map(move |&(_, pose)| [pose, half_turn * pose])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossings_lie_on_lines_that_go_where_their_heading_says() {
        let line = |pose: Pose2, turn: f32| {
            line_distance(pose.place(0.2 * Vec2::from_angle(turn)))
                < if pose.position.y.abs() == CIRCLE { 0.04 } else { 1e-4 }
        };
        for (kind, arms) in
            [(CrossingKind::L, [1, 1, 0, 0]), (CrossingKind::T, [1, 1, 0, 1]), (CrossingKind::X, [1; 4])]
        {
            assert_eq!(crossings(kind).count(), count(kind));
            for pose in crossings(kind) {
                for (quarter, arm) in (0_u8..).zip(arms) {
                    let there = line(pose, f32::from(quarter) * FRAC_PI_2);
                    assert_eq!(there, arm == 1, "{kind:?} {pose:?}, arm {quarter}");
                }
            }
        }
        assert_eq!([CrossingKind::L, CrossingKind::T, CrossingKind::X].map(count), [8, 6, 2]);
    }

    #[test]
    fn distances_are_those_of_the_rules() {
        for (x, y, distance) in [
            (0.0, 0.0, 0.0),
            (3.0, 0.3, 0.0),
            (2.4, -1.2, 0.0),
            (0.6, 0.0, 0.0),
            (-1.2, 0.0, 0.0),
            (1.0, 1.2, 0.8),
            (2.7, 0.0, 0.3),
            (-3.6, 2.0, 0.6),
            (0.3, 0.0, 0.3),
            (1.9, 0.0, 0.5),
        ] {
            assert!((line_distance(Vec2::new(x, y)) - distance).abs() < 1e-5, "at {x}, {y}");
        }
    }
}
