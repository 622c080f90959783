//! Thresholds of the detectors must change the detections.

use bica::Params;
use bica_field::FIELD;
use bica_motion::joints::Joint;
use bica_motion::model::NAO;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use bica_vision::ball::{BallDetection, BallFinder};
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::goal::{GoalDetection, GoalFinder};
use bica_vision::own_body::OwnBody;
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::{Camera, Intrinsics, Mounting};
use bica_vision::uncertainty::Errors;
use glam::{Affine3A, Vec2, Vec3};

use super::canvas::{Canvas, ORANGE, YELLOW};

/// Camera at a height of 0.5 m, pitched down by `pitch` rad.
fn camera(pitch: f32) -> Camera {
    let pose = Affine3A::from_translation(Vec3::new(0.0, 0.0, 0.5)) * Affine3A::from_rotation_y(pitch);
    Camera::new(pose, Intrinsics::nao_v6(320, 240))
}

/// Body of a standing robot that looks at its feet.
fn own_body() -> OwnBody {
    let mut angles = NAO.stand;
    angles[Joint::HeadPitch] = 0.5;
    let camera = Camera::of(NAO, CameraId::Bottom, &angles, Side::Left, 320, 240);
    OwnBody::of(NAO, &camera, CameraId::Bottom, &angles)
}

fn has_ball(canvas: &Canvas, own: &OwnBody, tuning: &BallDetection) -> bool {
    canvas.with_frame(|frame| {
        let end = FieldBoundary::find(frame, &BUILT_IN_TABLE);
        BallFinder::<512>::new(FIELD.ball_radius())
            .find_tuned(frame, &BUILT_IN_TABLE, &end, None, own, tuning)
            .is_some()
    })
}

#[test]
fn max_own_share_admits_a_partly_covered_ball() {
    let own = own_body();
    let places = (40..280).step_by(4).flat_map(|x| (60..200).step_by(4).map(move |y| Vec2::new(x as f32, y as f32)));
    // The detector tests the middle of the region: 0.4 of its size around its centroid.
    let half = places
        .into_iter()
        .find(|place| (0.3..0.5).contains(&own.share(*place, 0.8 * 20.0)))
        .expect("an edge of the body");
    let mut canvas = Canvas::field(320, 240, 0.0);
    canvas.disc(ORANGE, half, 20.0);
    for (max_own_share, found) in [(0.6, true), (0.2, false)] {
        let tuning = BallDetection { max_own_share, ..BallDetection::DEFAULT };
        assert_eq!(has_ball(&canvas, &own, &tuning), found, "{max_own_share}");
    }
}

#[test]
fn a_thick_post_needs_a_high_threshold_of_width() {
    let camera = camera(0.1);
    let foot = Vec3::new(2.0, 0.0, 0.0);
    let pixel = |at: Vec3| camera.pixel(at).expect("in front of the camera");
    let width = 2.0 * camera.sphere_radius(foot, FIELD.post_radius()).expect("in front of the camera");
    let mut canvas = Canvas::field(320, 240, pixel(Vec3::new(3.0, 0.0, 0.0)).y);
    canvas.bar(YELLOW, pixel(foot), pixel(Vec3::new(2.0, 0.0, FIELD.goal_height())), 2.2 * width);
    for (max_post_width, found) in [(1.6, false), (3.0, true)] {
        let tuning = GoalDetection { max_post_width, ..GoalDetection::DEFAULT };
        let goals = canvas.with_frame(|frame| {
            let end = FieldBoundary::find(frame, &BUILT_IN_TABLE);
            GoalFinder::<512>::new().find_tuned(frame, &BUILT_IN_TABLE, &end, Some((&camera, &Errors::NAO)), &tuning)
        });
        assert_eq!(goals.yellow.is_some(), found, "{max_post_width}: {width} px");
    }
}

#[test]
fn mounting_correction_turns_and_scales_the_camera() {
    let nominal = camera(0.2);
    assert_eq!(nominal.corrected(&Mounting::EXACT), nominal);
    let tilted = nominal.corrected(&Mounting { tilt: 0.1, ..Mounting::EXACT });
    let expected = camera(0.3);
    assert!(tilted.pose().abs_diff_eq(expected.pose(), 1e-6), "{tilted:?}");
    let panned = nominal.corrected(&Mounting { pan: 0.1, ..Mounting::EXACT });
    assert!(panned.pose().matrix3.x_axis.y > 0.05, "to the left: {panned:?}");
    let long = nominal.corrected(&Mounting { focal_scale: 1.5, ..Mounting::EXACT });
    assert_eq!(long.intrinsics().focal, 1.5 * nominal.intrinsics().focal);
    assert_eq!(long.pose(), nominal.pose());
}
