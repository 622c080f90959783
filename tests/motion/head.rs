//! Range, speed and aim of the head.

use bica_motion::head::{HeadAngles, look_at, look_at_over_ground, pitch_range};
use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::{self, ground_from_robot};
use bica_motion::model::NAO;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use glam::Vec3;
use proptest::prelude::*;

#[test]
fn the_pitch_range_at_each_yaw_is_the_published_one() {
    for (yaw, min, max) in [
        (0.0, -38.5, 29.5),
        (27.85, -38.5, 24.18),
        (-43.32, -31.4, 21.2),
        (51.74, -27.5, 18.91),
        (-62.45, -24.64, 17.19),
        (87.49, -18.91, 11.46),
        (119.52, -25.73, 18.91),
        // Halfway between two rows of the table.
        (35.585, -34.95, 22.69),
    ] {
        let range = pitch_range(NAO, f32::to_radians(yaw));
        let near = |found: f32, expected: f32| (found.to_degrees() - expected).abs() < 0.01;
        assert!(near(range.min, min) && near(range.max, max), "{yaw}°: {range:?}");
    }
}

fn any_camera() -> impl Strategy<Value = CameraId> {
    prop_oneof![Just(CameraId::Top), Just(CameraId::Bottom)]
}

proptest! {
    #![proptest_config(crate::motion::cases(1000))]

    #[test]
    fn clamped_angles_are_within_the_limits(yaw in -9.0_f32..9.0, pitch in -9.0_f32..9.0) {
        let clamped = HeadAngles { yaw, pitch }.clamped(NAO);
        prop_assert!(NAO.limits[Joint::HeadYaw].contains(clamped.yaw));
        prop_assert!(NAO.limits[Joint::HeadPitch].contains(clamped.pitch));
        prop_assert!(pitch_range(NAO, clamped.yaw).contains(clamped.pitch));
        prop_assert_eq!(clamped.clamped(NAO), clamped);
    }

    #[test]
    fn look_at_brings_the_point_to_the_optical_axis(
        camera in any_camera(), far in 0.2_f32..6.0, bearing in -3.1_f32..3.1, height in -0.6_f32..0.6,
    ) {
        let point = Vec3::new(far * bearing.cos(), far * bearing.sin(), height);
        let mut angles = Joints::all(0.0);
        look_at(NAO, camera, point).write(&mut angles);
        let seen = kinematics::camera(NAO, camera, &angles).inverse().transform_point3(point);
        prop_assert!(seen.x > 0.0, "{seen} is behind the camera");
        prop_assert!(seen.y.abs() < 1e-5 * far.max(1.0) && seen.z.abs() < 1e-5 * far.max(1.0), "{seen}");
    }

    #[test]
    fn look_at_over_ground_points_the_optical_axis(x in 0.3_f32..3.0, y in -2.0_f32..2.0, left in any::<bool>()) {
        let support = if left { Side::Left } else { Side::Right };
        let point = Vec3::new(x, y, 0.0325);
        let mut angles = NAO.stand;
        angles[Joint::LHipRoll] += 0.05;
        look_at_over_ground(NAO, CameraId::Top, point, support, &angles).write(&mut angles);
        let camera = ground_from_robot(NAO, support, &angles) * kinematics::camera(NAO, CameraId::Top, &angles);
        let seen = camera.inverse().transform_point3(point);
        prop_assert!(seen.x > 0.0 && seen.y.abs() < 1e-4 && seen.z.abs() < 1e-4, "{seen}");
    }

    #[test]
    fn head_reaches_its_target_within_maximum_speeds(
        from in (-2.1_f32..2.1, -0.7_f32..0.6), to in (-3.0_f32..3.0, -1.0_f32..1.0),
    ) {
        let mut now = HeadAngles { yaw: from.0, pitch: from.1 }.clamped(NAO);
        let target = HeadAngles { yaw: to.0, pitch: to.1 };
        let motion = NAO.head_speed;
        for _ in 0..600 {
            let next = motion.step(NAO, now, target, 0.01);
            prop_assert!((next.yaw - now.yaw).abs() <= 0.01 * motion.yaw + 1e-6);
            let most = motion.pitch + 0.5 * motion.yaw;
            prop_assert!((next.pitch - now.pitch).abs() <= 0.01 * most + 1e-6);
            prop_assert!(pitch_range(NAO, next.yaw).contains(next.pitch));
            now = next;
        }
        prop_assert_eq!(now, target.clamped(NAO));
    }
}

#[test]
fn head_stays_in_limits_for_non_finite_inputs() {
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let target = HeadAngles { yaw: value, pitch: value };
        let next = NAO.head_speed.step(NAO, HeadAngles::AHEAD, target, 0.01);
        assert!(next.yaw.is_finite() && pitch_range(NAO, next.yaw).contains(next.pitch), "{next:?}");
        let next = NAO.head_speed.step(NAO, HeadAngles::AHEAD, HeadAngles { yaw: 1.0, pitch: 0.2 }, value);
        assert!(next.yaw.is_finite() && pitch_range(NAO, next.yaw).contains(next.pitch), "{next:?}");
    }
}
