//! An object that is in view but not detected must lose confidence; an object out of view must not.

use bica_field::FIELD;
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use bica_vision::memory::ball::BallMemory;
use bica_vision::memory::visibility;
use bica_vision::own_body::OwnBody;
use bica_vision::projection::Camera;
use bica_vision::uncertainty;
use glam::Vec2;

const SIZE: Vec2 = Vec2::new(320.0, 240.0);
const RADIUS: f32 = FIELD.ball_radius();

/// View of a NAO: camera, yaw and pitch.
fn view(id: CameraId, yaw: f32, pitch: f32) -> (Camera, OwnBody) {
    let mut angles: Joints = NAO.stand;
    angles[Joint::HeadYaw] = yaw;
    angles[Joint::HeadPitch] = pitch;
    let camera = Camera::of(NAO, id, &angles, Side::Left, 320, 240);
    let body = OwnBody::of(NAO, &camera, id, &angles);
    (camera, body)
}

/// Looks for one second at the position of a remembered ball without detecting it; returns the confidence.
fn belief_after_looking(at: Vec2, (camera, body): &(Camera, OwnBody)) -> f32 {
    let mut ball = BallMemory::new(10.0);
    for _ in 0..10 {
        ball.advance(Pose2::ORIGIN, 1.0 / 30.0);
        ball.see(at, &uncertainty::round(0.008), 0.9);
    }
    for _ in 0..30 {
        ball.advance(Pose2::ORIGIN, 1.0 / 30.0);
        if ball.likeliest().is_some_and(|place| visibility::is_in_view(camera, SIZE, body, &place, RADIUS, 3.0)) {
            ball.miss();
        }
    }
    ball.confidence()
}

#[test]
fn missing_ball_is_forgotten_only_in_view() {
    let ahead = view(CameraId::Top, 0.0, 0.2);
    let unseen = 0.9 * 0.5_f32.powf(0.1);
    assert!(belief_after_looking(Vec2::new(1.0, 0.0), &ahead) < 0.02);
    for out_of_sight in [Vec2::new(0.15, 0.0), Vec2::new(1.0, 1.2), Vec2::new(-1.0, 0.0), Vec2::new(4.0, 0.0)] {
        let left = belief_after_looking(out_of_sight, &ahead);
        assert!((left - unseen).abs() < 1e-3, "{out_of_sight}: {left}");
    }
    let aside = view(CameraId::Top, 0.9, 0.2);
    assert!(belief_after_looking(Vec2::new(0.7, 0.9), &aside) < 0.02);
    assert!(belief_after_looking(Vec2::new(1.0, 0.0), &aside) > 0.8);
}

#[test]
fn ball_behind_the_own_body_is_not_in_view() {
    let down = view(CameraId::Bottom, 0.0, 0.4);
    assert!(belief_after_looking(Vec2::new(0.2, 0.0), &down) < 0.02);
    assert!(belief_after_looking(Vec2::new(0.06, 0.05), &down) > 0.8);
}

#[test]
fn ball_of_uncertain_position_is_not_in_view() {
    let (camera, body) = view(CameraId::Top, 0.0, 0.2);
    let mut ball = BallMemory::new(10.0);
    ball.see(Vec2::new(1.0, 0.0), &uncertainty::round(0.02), 0.9);
    let shows = |ball: &BallMemory| {
        ball.likeliest().is_some_and(|place| visibility::is_in_view(&camera, SIZE, &body, &place, RADIUS, 3.0))
    };
    assert!(shows(&ball));
    for _ in 0..100 {
        ball.advance(Pose2::new(0.2, 0.0, 0.0), 0.01);
        ball.advance(Pose2::new(-0.2, 0.0, 0.0), 0.01);
        if ball.likeliest().is_some_and(|place| uncertainty::largest(&place.covariance) > 0.3) {
            break;
        }
    }
    assert!(ball.likeliest().is_some() && !shows(&ball), "{ball:?}");
}
