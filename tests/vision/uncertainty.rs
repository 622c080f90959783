//! Uncertainty of ground positions, compared with sampled errors and finite differences.

use std::f32::consts::PI;

use bica_vision::projection::{Camera, Intrinsics};
use bica_vision::uncertainty::{self, Covariance, Errors};
use glam::{Affine3A, EulerRot, Quat, Vec2, Vec3};
use proptest::prelude::*;

/// Camera at head height, and a pixel of the ground up to 2.5 m away.
fn any_view() -> impl Strategy<Value = (Camera, Vec2)> {
    let angles = (-2.0_f32..2.0, 0.1_f32..1.1, -0.15_f32..0.15);
    let view = (angles, 0.4_f32..0.55, 0.0_f32..320.0, 0.0_f32..240.0);
    let view = view.prop_map(|((yaw, pitch, roll), height, x, y)| {
        let turn = Quat::from_euler(EulerRot::ZYX, yaw, pitch, roll);
        let pose = Affine3A::from_rotation_translation(turn, Vec3::new(0.06, 0.0, height));
        (Camera::new(pose, Intrinsics::nao_v6(320, 240)), Vec2::new(x, y))
    });
    view.prop_filter("near ground", |(camera, pixel)| {
        camera.ground(*pixel, 0.0325).is_some_and(|at| (0.2..2.5).contains(&at.length()))
    })
}

/// Camera with a pose error: a rotation about the ground axes, rad, and a height, m.
fn disturbed(camera: &Camera, turn: Vec3, height: f32) -> Camera {
    let turn = Affine3A::from_quat(Quat::from_scaled_axis(turn));
    let mut pose = camera.pose();
    pose.matrix3 = turn.matrix3 * pose.matrix3;
    pose.translation.z += height;
    Camera::new(pose, camera.intrinsics())
}

/// Low-discrepancy number in −1..1 for each dimension and index (additive recurrence of the generalised golden
/// ratio for six dimensions, Roberts 2018).
fn even(index: u32, dimension: i32) -> f64 {
    const RATIO: f64 = 1.091_084_908_187_068_7;
    2.0 * (0.5 + f64::from(index + 1) * RATIO.powi(-dimension - 1)).fract() - 1.0
}

/// Frobenius norm.
fn norm(covariance: &Covariance) -> f32 {
    covariance.to_cols_array().iter().map(|value| value * value).sum::<f32>().sqrt()
}

/// Sample covariance of the ground position under `draws` random errors.
fn drawn(camera: &Camera, pixel: Vec2, z: f32, errors: &Errors, draws: u32) -> Option<Covariance> {
    // Uniform with standard deviation 1.
    let number = |index, dimension| (3.0_f64.sqrt() * even(index, dimension)) as f32;
    let middle = camera.ground(pixel, z)?;
    let (mut mean, mut sum) = (Vec2::ZERO, Covariance::ZERO);
    for index in 0..draws {
        let n = [0, 1, 2, 3, 4, 5].map(|dimension| number(index, dimension));
        let turn = Vec3::new(errors.lean * n[0], errors.lean * n[1], errors.pan * n[2]);
        let camera = disturbed(camera, turn, errors.height * n[3]);
        let off = camera.ground(pixel + errors.pixels * Vec2::new(n[4], n[5]), z)? - middle;
        mean += off / draws as f32;
        sum += uncertainty::square(off) / draws as f32;
    }
    Some(sum - uncertainty::square(mean))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn covariance_equals_that_of_sampled_small_errors((camera, pixel) in any_view(), z in 0.0_f32..0.04) {
        let errors = Errors { lean: 0.004, pan: 0.01, height: 0.005, pixels: 0.5 };
        let computed = uncertainty::of_ground(&camera, pixel, z, &errors).expect("ground");
        let drawn = drawn(&camera, pixel, z, &errors, 4000).expect("ground");
        let off = norm(&(computed - drawn)) / norm(&drawn);
        prop_assert!(off < 0.06, "{computed} is not {drawn}: {off}");
    }

    #[test]
    fn standard_deviation_of_a_robot_equals_samples((camera, pixel) in any_view()) {
        let errors = Errors::NAO;
        let computed = uncertainty::largest(&uncertainty::of_ground(&camera, pixel, 0.0, &errors).expect("ground"));
        let drawn = uncertainty::largest(&drawn(&camera, pixel, 0.0, &errors, 2000).expect("ground"));
        prop_assert!((0.8..1.1).contains(&(computed / drawn)), "{computed} m is not {drawn} m");
    }

    #[test]
    fn each_error_alone_equals_its_finite_difference((camera, pixel) in any_view(), which in 0_usize..5) {
        let none = Errors { lean: 0.0, pan: 0.0, height: 0.0, pixels: 0.0 };
        let small = 1e-3;
        let (errors, shifts): (Errors, Vec<(Vec3, f32, Vec2)>) = match which {
            0 => (
                Errors { lean: small, ..none },
                vec![(small * Vec3::X, 0.0, Vec2::ZERO), (small * Vec3::Y, 0.0, Vec2::ZERO)],
            ),
            1 => (Errors { pan: small, ..none }, vec![(small * Vec3::Z, 0.0, Vec2::ZERO)]),
            2 => (Errors { height: small, ..none }, vec![(Vec3::ZERO, small, Vec2::ZERO)]),
            3 => (Errors { pixels: 0.3, ..none }, vec![(Vec3::ZERO, 0.0, 0.3 * Vec2::X), (Vec3::ZERO, 0.0, 0.3 * Vec2::Y)]),
            _ => (none, vec![]),
        };
        let place = |turn: Vec3, height: f32, shift: Vec2| {
            disturbed(&camera, turn, height).ground(pixel + shift, 0.0).expect("ground")
        };
        let central = |(turn, height, shift): &(Vec3, f32, Vec2)| {
            uncertainty::square(0.5 * (place(*turn, *height, *shift) - place(-*turn, -*height, -*shift)))
        };
        let expected: Covariance = shifts.iter().map(central).sum();
        let computed = uncertainty::of_ground(&camera, pixel, 0.0, &errors).expect("ground");
        prop_assert!(norm(&(computed - expected)) <= 0.02 * norm(&expected) + 1e-12, "{computed} is not {expected}");
    }

    #[test]
    fn largest_deviation_bounds_each_direction(
        x in -1.0_f32..1.0, y in -1.0_f32..1.0, u in -1.0_f32..1.0, v in -1.0_f32..1.0, angle in -3.0_f32..3.0,
    ) {
        let covariance = uncertainty::square(Vec2::new(x, y)) + uncertainty::square(Vec2::new(u, v));
        let largest = uncertainty::largest(&covariance);
        let along = |angle: f32| Vec2::from_angle(angle).dot(covariance * Vec2::from_angle(angle));
        prop_assert!(along(angle) <= largest * largest + 1e-5);
        let sure = (0..2000_u16).map(|step| along(f32::from(step) * PI / 2000.0)).fold(0.0, f32::max).sqrt();
        prop_assert!((sure - largest).abs() < 1e-3, "{largest} is not {sure}");
    }
}

#[test]
fn covariance_near_the_horizon_is_finite_or_none() {
    let camera = Camera::new(Affine3A::from_translation(Vec3::new(0.0, 0.0, 0.5)), Intrinsics::nao_v6(320, 240));
    let horizon = camera.horizon(160.0).expect("upright");
    for below in [-10.0, -1e-3, 0.0, 1e-6, 1e-4, 1e-2, 1.0, f32::NAN, f32::INFINITY] {
        let covariance = uncertainty::of_ground(&camera, Vec2::new(160.0, horizon + below), 0.0, &Errors::NAO);
        assert!(covariance.is_none_or(|covariance| covariance.is_finite()));
    }
}
