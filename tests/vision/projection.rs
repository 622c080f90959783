//! Projection to the ground and back, compared with published values and with itself.

use bica_motion::joints::Joints;
use bica_motion::kinematics;
use bica_motion::model::NAO;
use bica_motion::robot::CameraId;
use bica_vision::projection::{Camera, Intrinsics};
use glam::{Affine3A, EulerRot, Quat, Vec2, Vec3};
use proptest::prelude::*;

/// Camera with the hips 0.230 m above the ground and all joints at zero, as in the published values.
fn standing(id: CameraId, width: u16, height: u16) -> Camera {
    let hips = Affine3A::from_translation(Vec3::new(0.0, 0.0, 0.230));
    Camera::new(hips * kinematics::camera(NAO, id, &Joints::all(0.0)), Intrinsics::nao_v6(width, height))
}

/// Published values: camera, pixel at 640 × 480, and its ground point, m.
const VECTORS: [(CameraId, [f32; 2], [f32; 2]); 6] = [
    (CameraId::Top, [320.0, 240.0], [24.174, 0.0]),
    (CameraId::Top, [320.0, 479.0], [1.286, 0.0]),
    (CameraId::Top, [500.0, 400.0], [1.852, -0.525]),
    (CameraId::Bottom, [320.0, 240.0], [0.604, 0.0]),
    (CameraId::Bottom, [320.0, 479.0], [0.307, 0.0]),
    (CameraId::Bottom, [500.0, 400.0], [0.3815, -0.159]),
];

#[test]
fn camera_heights_equal_the_published_ones() {
    assert!((standing(CameraId::Top, 640, 480).pose().translation.z - 0.505_14).abs() < 1e-5);
    assert!((standing(CameraId::Bottom, 640, 480).pose().translation.z - 0.459_24).abs() < 1e-5);
}

#[test]
fn ground_points_of_pixels_equal_the_published_ones() {
    for (id, pixel, expected) in VECTORS {
        for scale in [1, 2, 4] {
            let camera = standing(id, 640 / scale, 480 / scale);
            let found = camera.ground(Vec2::from(pixel) / f32::from(scale), 0.0).expect("below the horizon");
            // Tolerance: half a unit of the last published digit; the point of the first row is 24 m away.
            let error = (found - Vec2::from(expected)).abs().max_element();
            assert!(error <= 0.000_55, "{id:?} {pixel:?} at 1/{scale}: {found} is {error} off");
        }
    }
}

fn any_camera() -> impl Strategy<Value = Camera> {
    let angles = (-3.1_f32..3.1, -0.6_f32..1.2, -0.3_f32..0.3);
    let place = (-0.2_f32..0.2, -0.2_f32..0.2, 0.2_f32..0.6);
    let size = prop_oneof![Just((160, 120)), Just((320, 240)), Just((640, 480))];
    (angles, place, size).prop_map(|((yaw, pitch, roll), (x, y, z), (width, height))| {
        let turn = Quat::from_euler(EulerRot::ZYX, yaw, pitch, roll);
        let pose = Affine3A::from_rotation_translation(turn, Vec3::new(x, y, z));
        Camera::new(pose, Intrinsics::nao_v6(width, height))
    })
}

fn pixel_of(camera: &Camera) -> impl Strategy<Value = Vec2> + use<> {
    let size = 2.0 * camera.intrinsics().centre;
    (0.0..size.x, 0.0..size.y).prop_map(|(x, y)| Vec2::new(x, y))
}

fn camera_and_pixel() -> impl Strategy<Value = (Camera, Vec2)> {
    any_camera().prop_flat_map(|camera| (Just(camera), pixel_of(&camera)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn projection_to_the_ground_is_invertible((camera, pixel) in camera_and_pixel(), z in 0.0_f32..0.15) {
        if let Some(point) = camera.ground(pixel, z) {
            let back = camera.pixel(point.extend(z));
            // At a large distance one pixel covers many metres, beyond the precision of f32.
            if point.length() < 50.0 {
                prop_assert!(back.is_some_and(|back| (back - pixel).length() < 0.05), "{back:?} for {pixel}");
            }
        } else {
            prop_assert!(camera.ray(pixel).z >= 0.0);
        }
    }

    #[test]
    fn only_pixels_below_the_horizon_meet_the_ground((camera, pixel) in camera_and_pixel()) {
        let row = camera.horizon(pixel.x).expect("cameras here are upright");
        prop_assume!((row - pixel.y).abs() > 0.01);
        prop_assert_eq!(camera.ground(pixel, 0.0).is_some(), pixel.y > row);
        let ray = camera.ray(Vec2::new(pixel.x, row)).normalize();
        prop_assert!(ray.z.abs() < 1e-4, "{ray} is not level");
    }

    #[test]
    fn distance_from_size_equals_distance_from_position((camera, pixel) in camera_and_pixel(), radius in 0.03_f32..0.05) {
        if let Some(place) = camera.ground(pixel, radius).filter(|place| place.length() < 6.0) {
            let place = place.extend(radius);
            let distance = (place - Vec3::from(camera.pose().translation)).length();
            prop_assume!(distance > 0.15);
            let pixels = camera.sphere_radius(place, radius).expect("in front");
            let found = camera.distance_by_radius(pixel, pixels, radius).expect("a distance");
            prop_assert!((found / distance - 1.0).abs() < 0.04, "{found} for {distance}");
        }
    }

    #[test]
    fn turning_the_camera_by_the_offset_centres_the_pixel((camera, pixel) in camera_and_pixel()) {
        let middle = camera.intrinsics().centre;
        let offset = camera.offset(pixel);
        prop_assert_eq!(offset.x > 0.0, pixel.x < middle.x);
        prop_assert_eq!(offset.y > 0.0, pixel.y > middle.y);
        let along = Camera::new(Affine3A::from_rotation_z(offset.x), camera.intrinsics());
        let seen = along.pixel(Vec3::new(1.0, -(pixel.x - middle.x) / camera.intrinsics().focal.x, 0.0));
        prop_assert!(seen.is_some_and(|seen| (seen.x - middle.x).abs() < 0.01));
    }

    #[test]
    fn projections_are_finite_for_any_pose(
        parts in prop::array::uniform12(prop_oneof![
            Just(f32::NAN), Just(f32::INFINITY), Just(0.0_f32), Just(f32::MAX), -2.0_f32..2.0,
        ]),
        x in -1e4_f32..1e4,
        y in -1e4_f32..1e4,
    ) {
        let camera = Camera::new(Affine3A::from_cols_array(&parts), Intrinsics::nao_v6(320, 240));
        let pixel = Vec2::new(x, y);
        prop_assert!(camera.ground(pixel, 0.0).is_none_or(Vec2::is_finite));
        prop_assert!(camera.pixel(Vec3::new(x, y, 0.1)).is_none_or(Vec2::is_finite));
        prop_assert!(camera.horizon(x).is_none_or(f32::is_finite));
        prop_assert!(camera.distance_by_radius(pixel, y, 0.03).is_none_or(f32::is_finite));
        prop_assert!(camera.place_by_radius(pixel, y, 0.03).is_none_or(Vec3::is_finite));
        prop_assert!(camera.sphere_radius(Vec3::new(x, y, 0.0), 0.03).is_none_or(f32::is_finite));
    }
}
