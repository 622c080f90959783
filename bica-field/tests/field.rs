//! Comparison of the field of 2009 with the figures of its rules.

#![expect(clippy::float_cmp, reason = "derived lengths must be the nearest floats")]

use core::f32::consts::{FRAC_PI_2, PI};

use bica_field::{Crossing, CrossingKind, GoalColour, SPL_2009};
use glam::Vec2;

#[test]
fn derived_lengths_are_the_nearest_floats() {
    let field = SPL_2009;
    assert_eq!(field.carpet_corner(), Vec2::new(3.7, 2.7));
    assert_eq!(field.field_corner(), Vec2::new(3.0, 2.0));
    assert_eq!(field.penalty_area_corner(), Vec2::new(2.4, 1.5));
    assert_eq!(field.goal_post(), Vec2::new(3.05, 0.7));
    assert_eq!(field.throw_in_corner(), Vec2::new(2.0, 1.6));
    let lengths = [
        (field.line_width(), 0.05),
        (field.centre_circle_radius(), 0.6),
        (field.penalty_mark(), 1.2),
        (field.penalty_mark_size(), 0.1),
        (field.goal_width(), 1.4),
        (field.goal_height(), 0.8),
        (field.goal_back(), 3.5),
        (field.goal_panel(), 0.4),
        (field.post_diameter(), 0.1),
        (field.post_radius(), 0.05),
        (field.crossbar_radius(), 0.025),
        (field.ball_radius(), 0.0325),
    ];
    for (derived, expected) in lengths {
        assert_eq!(derived, expected);
    }
}

#[test]
fn left_post_comes_first() {
    assert_eq!(SPL_2009.goal_posts(true), [Vec2::new(3.05, 0.7), Vec2::new(3.05, -0.7)]);
    assert_eq!(SPL_2009.goal_posts(false), [Vec2::new(-3.05, -0.7), Vec2::new(-3.05, 0.7)]);
}

#[test]
fn line_distances_are_those_of_rules() {
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
        assert!((SPL_2009.line_distance(Vec2::new(x, y)) - distance).abs() < 1e-5, "at {x}, {y}");
    }
    assert!(SPL_2009.line_distance(Vec2::new(f32::NAN, f32::NAN)).is_nan());
}

#[test]
fn crossing_arms_match_its_kind() {
    let is_line = |crossing: &Crossing, turn: f32| {
        let tolerance = if crossing.kind == CrossingKind::X { 0.04 } else { 1e-4 };
        let point = crossing.position + 0.2 * Vec2::from_angle(crossing.heading + turn);
        SPL_2009.line_distance(point) < tolerance
    };
    for crossing in SPL_2009.half_crossings() {
        let expected = match crossing.kind {
            CrossingKind::L => [true, true, false, false],
            CrossingKind::T => [true, true, false, true],
            CrossingKind::X => [true; 4],
        };
        assert_eq!([0.0, FRAC_PI_2, PI, -FRAC_PI_2].map(|turn| is_line(&crossing, turn)), expected, "{crossing:?}");
    }
    let count = |kind| SPL_2009.half_crossings().iter().filter(|crossing| crossing.kind == kind).count();
    assert_eq!([CrossingKind::L, CrossingKind::T, CrossingKind::X].map(count), [4, 3, 1]);
}

#[test]
fn each_goal_colour_is_other_of_other() {
    for colour in [GoalColour::Yellow, GoalColour::SkyBlue] {
        assert_ne!(colour.other(), colour);
        assert_eq!(colour.other().other(), colour);
    }
    assert_eq!(GoalColour::SkyBlue.to_string(), "sky-blue");
}
