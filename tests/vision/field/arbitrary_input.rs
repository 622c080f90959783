//! Localization and field markings with arbitrary input: no panic, finite results.

use std::f32::consts::PI;

use bica_core::Params;
use bica_field::{CrossingKind, FIELD, GoalColour};
use bica_motion::pose::Pose2;
use bica_vision::centre_circle::{self, CentreCircle};
use bica_vision::crossings;
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::frame::Frame;
use bica_vision::goal::{GoalFinder, PostSide};
use bica_vision::lines::{self, Line};
use bica_vision::localization::{Localizer, PostSighting, Sightings};
use bica_vision::markings::{MarkingDetection, Markings};
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::{Camera, Intrinsics};
use bica_vision::robots;
use glam::{Affine3A, Mat3A, Quat, Vec2, Vec3, Vec3A};
use proptest::prelude::*;

fn number() -> impl Strategy<Value = f32> {
    prop_oneof![8 => -8.0_f32..8.0, 1 => any::<f32>(), 1 => prop_oneof![Just(f32::NAN), Just(f32::INFINITY), Just(0.0_f32)]]
}

fn place() -> impl Strategy<Value = Vec2> {
    (number(), number()).prop_map(Vec2::from)
}

fn pose() -> impl Strategy<Value = Pose2> {
    (place(), number()).prop_map(|(position, heading)| Pose2 { position, heading })
}

fn kind() -> impl Strategy<Value = CrossingKind> {
    prop_oneof![Just(CrossingKind::L), Just(CrossingKind::T), Just(CrossingKind::X)]
}

fn post() -> impl Strategy<Value = PostSighting> {
    let side = prop_oneof![Just(PostSide::Left), Just(PostSide::Right), Just(PostSide::Unknown)];
    (place(), side, any::<bool>(), any::<bool>()).prop_map(|(at, side, attacked, has_base)| PostSighting {
        at,
        side,
        attacked,
        has_base,
    })
}

fn sightings() -> impl Strategy<Value = Sightings> {
    let circle = prop::option::of((place(), prop::option::of(place())));
    let lists = (prop::collection::vec(place(), 0..24), prop::collection::vec((kind(), pose()), 0..12));
    (lists, circle, prop::collection::vec(post(), 0..4)).prop_map(|((points, crossings), circle, posts)| Sightings {
        points: points.into_iter().collect(),
        crossings: crossings.into_iter().collect(),
        circle: circle.map(|(centre, halfway)| CentreCircle { centre, halfway }),
        posts: posts.into_iter().collect(),
    })
}

fn camera() -> impl Strategy<Value = Camera> {
    let sound = (-0.5_f32..1.2, -3.1_f32..3.1, -0.2_f32..0.2, 0.1_f32..0.7).prop_map(|(pitch, yaw, roll, height)| {
        let turn = Quat::from_rotation_z(yaw) * Quat::from_rotation_y(pitch) * Quat::from_rotation_x(roll);
        Affine3A::from_rotation_translation(turn, Vec3::new(0.0, 0.0, height))
    });
    let any = prop::array::uniform12(number()).prop_map(|n| Affine3A {
        matrix3: Mat3A::from_cols_array(&[n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]]),
        translation: Vec3A::new(n[9], n[10], n[11]),
    });
    prop_oneof![sound, any].prop_map(|pose| Camera::new(pose, Intrinsics::nao_v6(160, 120)))
}

/// Random image of noise or of rectangles in the colours of the field.
fn picture() -> impl Strategy<Value = Vec<u8>> {
    const COLOURS: [[u8; 4]; 5] =
        [[70, 113, 110, 70], [190, 126, 127, 190], [125, 85, 165, 125], [170, 60, 140, 170], [95, 150, 95, 95]];
    let noise = prop::collection::vec(any::<u8>(), 2 * 160 * 120);
    let block = (0_usize..5, 0_usize..80, 0_usize..120, 1_usize..80, 1_usize..120);
    let blocks = prop::collection::vec(block, 1..40).prop_map(|blocks| {
        let mut bytes = [COLOURS[0][0], COLOURS[0][1], COLOURS[0][3], COLOURS[0][2]].repeat(80 * 120);
        for (colour, x, y, width, height) in blocks {
            let [y0, cb, cr, y1] = COLOURS[colour];
            for row in y..(y + height).min(120) {
                for column in x..(x + width).min(80) {
                    bytes[4 * (80 * row + column)..][..4].copy_from_slice(&[y0, cb, y1, cr]);
                }
            }
        }
        bytes
    });
    prop_oneof![1 => noise, 3 => blocks]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn poses_are_on_the_carpet_for_any_sightings(steps in prop::collection::vec((pose(), sightings()), 1..12), seed: u64) {
        let mut localizer = Localizer::<60>::new(seed);
        for (motion, sightings) in steps {
            localizer.advance(motion);
            localizer.see(sightings);
            let estimate = localizer.estimate();
            for pose in localizer.particles().iter().chain(estimate.iter().map(|estimate| &estimate.pose)) {
                prop_assert!(pose.position.abs().cmple(FIELD.carpet_corner()).all() && pose.heading.abs() < 1.0001 * PI, "{pose:?}");
            }
            if let Some(estimate) = estimate {
                let variances = estimate.covariance.diagonal();
                prop_assert!((0.0..=1.0).contains(&estimate.belief) && estimate.covariance.is_finite(), "{estimate:?}");
                prop_assert!(variances.cmpge(glam::Vec3::ZERO).all(), "{estimate:?}");
            }
        }
    }

    #[test]
    fn detections_in_any_image_are_finite_and_in_range(bytes in picture(), camera in camera()) {
        let frame = Frame::new(160, 120, &bytes).expect("a frame");
        let end = FieldBoundary::find(&frame, &BUILT_IN_TABLE);
        let found = lines::find(&frame, &BUILT_IN_TABLE, &end, Some(&camera));
        let markings = Markings::of(&frame, &BUILT_IN_TABLE, &camera, &found);
        prop_assert!(markings.crossings.iter().all(|crossing| crossing.at.is_finite()));
        prop_assert!(markings.circle.is_none_or(|circle| circle.centre.is_finite()));
        let goals = GoalFinder::<256>::new().find(&frame, &BUILT_IN_TABLE, &end, Some(&camera));
        let sightings = Sightings::of(&markings, &goals, GoalColour::Yellow, &camera);
        let on_ground = &markings.lines;
        prop_assert!(on_ground.iter().all(|line| line.from.length().max(line.to.length()) <= 4.5));
        prop_assert!(sightings.points.iter().all(|point| point.length() <= 4.6));
        for robot in robots::find(&frame, &BUILT_IN_TABLE, &end, Some(&camera)) {
            prop_assert!(robot.min.cmple(robot.max).all() && robot.min.min_element() >= -1.0, "{robot:?}");
            prop_assert!(robot.max.x <= 160.0 && robot.max.y <= 119.0, "{robot:?}");
        }
    }

    #[test]
    fn crossings_of_arbitrary_lines_are_finite(
        bytes in picture(),
        camera in camera(),
        ends in prop::collection::vec((place(), place()), 0..24),
    ) {
        let frame = Frame::new(160, 120, &bytes).expect("a frame");
        let lines: Vec<Line> = ends.into_iter().map(|(from, to)| Line { from, to }).collect();
        let tuning = MarkingDetection::DEFAULT;
        let circle = centre_circle::find(&frame, &BUILT_IN_TABLE, &camera, &lines, &tuning);
        prop_assert!(circle.is_none_or(|circle| circle.centre.is_finite()));
        let crossings = crossings::find(&frame, &BUILT_IN_TABLE, &camera, &lines, circle.as_ref(), tuning.max_crossing_distance);
        prop_assert!(crossings.iter().all(|crossing| crossing.at.is_finite() && crossing.ground.position.is_finite()));
    }
}
