//! The approach to the ball.

use bica_motion::robot::CameraId;
use bica_player::behaviour::{FaceBall, FollowBall};
use bica_player::input::RobotState;
use bica_player::motion::Head;
use bica_player::output::{CameraSelector, Motors};
use bica_player::perception::Bearing;
use bica_player::roles::{Ball, Legs};

use super::*;

activation_tree! {
    struct Approaching {
        root: FollowBall,
        cycle_hz: 100,
        roles: { Ball: Scene, Legs: Feet },
        components: [FollowBall, FaceBall, Head, CameraSelector, Motors, RobotState, Scene, Feet],
    }
}

#[test]
fn it_walks_to_a_ball_ahead_and_turns_to_one_aside() {
    let mut test = Harness::new(Approaching::new());
    test.run_for(ms(200));
    assert_eq!(request(&test), Request::Stand, "without a ball");
    scene(&mut test).shows_ball(Vec2::X * 2.0);
    test.run_for(ms(500));
    assert!(matches!(request(&test), Request::Straight { forward, .. } if forward > 0.0));
    scene(&mut test).shows_ball(Vec2::Y * 2.0);
    test.run_for(ms(500));
    assert!(matches!(request(&test), Request::Turn(speed) if speed > 0.0));
}

#[test]
fn a_ball_that_comes_no_nearer_is_sidestepped() {
    let mut test = Harness::new(Approaching::new());
    scene(&mut test).shows_ball(Vec2::X * 2.0);
    test.run_for(ms(5500));
    assert!(matches!(request(&test), Request::Step(velocity) if velocity.left > 0.0));
}

#[test]
fn a_ball_at_the_feet_is_reached() {
    let mut test = Harness::new(Approaching::new());
    scene(&mut test).shows_ball(Vec2::X * 0.2);
    scene(&mut test).bearing = Some(Bearing { pan: 0.0, down: 1.1 });
    scene(&mut test).camera = Some(CameraId::Bottom);
    test.run_for(ms(2000));
    assert!(test.tree().get::<FollowBall>().reached());
    assert_eq!(request(&test), Request::Stand);
    scene(&mut test).is_confirmed = false;
    test.run_for(ms(100));
    assert!(!test.tree().get::<FollowBall>().reached(), "a single sighting");
}
