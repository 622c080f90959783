//! Hypothesis tests of balls, posts and other objects in images of a camera with pose errors.

use bica_field::FIELD;
use bica_vision::hypothesis::{self, ImageCircle};
use bica_vision::projection::{Camera, Intrinsics};
use bica_vision::uncertainty::{Errors, largest};
use glam::{Affine3A, EulerRot, Quat, Vec2, Vec3};
use proptest::prelude::*;

const RADIUS: f32 = FIELD.ball_radius();

fn camera(yaw: f32, pitch: f32, height: f32) -> Camera {
    let turn = Quat::from_euler(EulerRot::ZYX, yaw, pitch, 0.0);
    let pose = Affine3A::from_rotation_translation(turn, Vec3::new(0.05, 0.0, height));
    Camera::new(pose, Intrinsics::nao_v6(320, 240))
}

/// Camera that looks approximately at a ground position up to `farthest` metres away, with that position.
fn view(far: f32) -> impl Strategy<Value = (Camera, Vec2)> {
    let parts = (0.3_f32..far, -0.8_f32..0.8, -0.2_f32..0.2, -0.2_f32..0.2, 0.42_f32..0.52);
    parts.prop_map(|(distance, way, yaw, pitch, height)| {
        let place = distance * Vec2::from_angle(way);
        let down = height.atan2(distance - 0.05);
        (camera(place.y.atan2(place.x - 0.05) + yaw, down + pitch, height), place)
    })
}

fn circle(camera: &Camera, at: Vec3, radius: f32) -> Option<ImageCircle> {
    Some(ImageCircle { centre: camera.pixel(at)?, radius: camera.sphere_radius(at, radius)? })
}

/// Camera of a robot with an unknown lean, as the robot assumes it.
fn leaning(camera: &Camera, lean: Vec2) -> Camera {
    let turn = Affine3A::from_quat(Quat::from_scaled_axis(lean.extend(0.0)));
    let mut pose = camera.pose();
    pose.matrix3 = turn.matrix3 * pose.matrix3;
    Camera::new(pose, camera.intrinsics())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn ball_on_the_ground_is_accepted_at_its_position((camera, place) in view(3.0)) {
        let seen = circle(&camera, place.extend(RADIUS), RADIUS).expect("in front");
        let off = seen.size_error(&camera, RADIUS, &Errors::NAO).expect("a number");
        prop_assert!(off.abs() < 0.6, "{off} deviations");
        let found = seen.ball(&camera, RADIUS, &Errors::NAO).expect("a ball");
        prop_assert!(found.position.distance(place) < 0.03 * place.length(), "{found:?}");
    }

    #[test]
    fn ball_within_its_covariance_is_accepted(
        (camera, place) in view(3.0), x in -0.03_f32..0.03, y in -0.03_f32..0.03, part in -0.2_f32..0.2,
    ) {
        let believed = leaning(&camera, Vec2::new(x, y));
        let mut seen = circle(&camera, place.extend(RADIUS), RADIUS).expect("in front");
        seen.radius *= 1.0 + part;
        let found = seen.ball(&believed, RADIUS, &Errors::NAO);
        let found = found.expect("two standard deviations of each error are less than three of their sum");
        let off = found.position - place;
        let distance = off.dot(found.covariance.try_inverse().expect("a covariance") * off);
        prop_assert!(distance < 16.0, "{distance} squared deviations");
        let alone = bica_vision::uncertainty::of_ground(&believed, seen.centre, RADIUS, &Errors::NAO);
        prop_assert!(alone.is_none_or(|alone| largest(&found.covariance) <= largest(&alone) + 1e-4));
    }

    #[test]
    fn circle_of_a_wrong_size_is_rejected((camera, place) in view(1.2), is_large in any::<bool>()) {
        let radius = if is_large { 2.5 * RADIUS } else { 0.4 * RADIUS };
        let seen = circle(&camera, place.extend(RADIUS), radius).expect("in front");
        prop_assert!(seen.ball(&camera, RADIUS, &Errors::NAO).is_none());
    }

    #[test]
    fn ball_in_the_air_is_rejected((camera, place) in view(1.5), height in 0.35_f32..0.6) {
        // Directly below the camera the ball may be behind the image plane.
        let seen = circle(&camera, place.extend(height), RADIUS);
        prop_assume!(seen.is_some());
        let seen = seen.expect("in front");
        prop_assert!(seen.ball(&camera, RADIUS, &Errors::NAO).is_none());
    }

    #[test]
    fn post_of_a_wrong_height_is_rejected(
        (camera, place) in view(3.0), x in -0.03_f32..0.03, y in -0.03_f32..0.03,
    ) {
        prop_assume!(place.length() > 1.0);
        let ends = |height: f32| camera.pixel(place.extend(0.0)).zip(camera.pixel(place.extend(height)));
        let believed = leaning(&camera, Vec2::new(x, y));
        let fits = |believed: &Camera, height: f32| {
            let Some((foot, top)) = ends(height) else { return height.to_bits() == FIELD.goal_height().to_bits() };
            hypothesis::is_as_high(believed, foot, top, FIELD.goal_height(), &Errors::NAO)
        };
        prop_assert!(fits(&camera, FIELD.goal_height()));
        prop_assert!(fits(&believed, FIELD.goal_height()));
        if place.length() < 2.0 {
            prop_assert!(!fits(&camera, 0.5 * FIELD.goal_height()));
            prop_assert!(!fits(&camera, 2.0 * FIELD.goal_height()));
        }
    }

    #[test]
    fn positions_are_finite_for_any_pose(
        parts in prop::array::uniform12(prop_oneof![
            Just(f32::NAN), Just(f32::INFINITY), Just(0.0_f32), Just(f32::MAX), -2.0_f32..2.0,
        ]),
        x in -1e4_f32..1e4, y in -1e4_f32..1e4, radius in -1.0_f32..1e4,
    ) {
        let camera = Camera::new(Affine3A::from_cols_array(&parts), Intrinsics::nao_v6(320, 240));
        let found = ImageCircle { centre: Vec2::new(x, y), radius }.ball(&camera, RADIUS, &Errors::NAO);
        prop_assert!(found.is_none_or(|found| found.position.is_finite()));
    }
}
