//! The search for the ball.

use bica_player::behaviour::{FaceBall, SearchBall};
use bica_player::input::{CameraInput, Colours, RobotProfile, RobotState};
use bica_player::motion::Head;
use bica_player::output::{CameraSelector, Motors};
use bica_player::perception::{CameraPose, FieldBoundary, Odometry, OwnBody, RobotDetector};
use bica_player::roles::{Ball, Legs, Odometer, Place};

use super::*;

activation_tree! {
    struct Searching {
        root: SearchBall,
        cycle_hz: 100,
        roles: { Ball: Scene, Odometer: Scene, Place: Scene, Legs: Feet },
        components: [
            SearchBall, FaceBall, Head, CameraSelector, Motors, RobotState, RobotProfile,
            RobotDetector, FieldBoundary, CameraPose, OwnBody, Odometry, Colours, CameraInput,
            Scene, Feet,
        ],
    }
}

/// A search without images: nothing is known of the way ahead.
fn search() -> Harness<Searching> {
    Harness::of_box(Box::new(Searching::new()))
}

fn reaches(test: &mut Harness<Searching>, state: &str) {
    test.reaches::<SearchBall>(state, ms(60_000));
}

#[test]
fn a_remembered_ball_is_looked_for_first() {
    let mut test = search();
    scene(&mut test).shows_ball(Vec2::new(1.0, -0.2));
    test.stays::<SearchBall>("recall", ms(300));
    assert_eq!(request(&test), Request::Stand);
    reaches(&mut test, "scan");
    assert!(test.tree().get::<SearchBall>().first_side() < 0.0, "the side of the ball first");
}

#[test]
fn a_far_remembered_ball_is_walked_to() {
    let mut test = search();
    scene(&mut test).shows_ball(Vec2::X * 5.0);
    reaches(&mut test, "find_path");
    test.run_for(ms(50));
    assert!(matches!(request(&test), Request::Turn(_)));
}

#[test]
fn search_without_a_ball_turns_a_full_circle() {
    let mut test = search();
    for state in ["scan", "turn_around"] {
        reaches(&mut test, state);
    }
    test.run_for(ms(50));
    assert!(matches!(request(&test), Request::Turn(speed) if speed > 0.0));
    reaches(&mut test, "scan");
    assert_eq!(test.tree().get::<SearchBall>().turns_here(), 1);
    reaches(&mut test, "find_path");
}

#[test]
fn recall_without_a_path_ends_in_a_scan() {
    let mut test = search();
    reaches(&mut test, "scan");
    test.tree_mut().get_mut::<SearchBall>().search_elsewhere();
    test.reaches::<SearchBall>("find_path", ms(100));
    test.reaches::<SearchBall>("scan", ms(12_100));
}
