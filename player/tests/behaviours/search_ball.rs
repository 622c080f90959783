//! The search for the ball.

use bica_player::behaviour::{FaceBall, SearchBall};
use bica_player::input::RobotState;
use bica_player::motion::Head;
use bica_player::output::{CameraSelector, Motors};
use bica_player::roles::{Ball, Carpet, Eye, Legs, Odometer, Place, Robots};

use super::*;

activation_tree! {
    struct Searching {
        root: SearchBall,
        cycle_hz: 100,
        roles: { Ball: Scene, Odometer: Scene, Place: Scene, Legs: Feet, Robots: Scene, Carpet: Scene, Eye: Scene },
        components: [SearchBall, FaceBall, Head, CameraSelector, Motors, RobotState, Scene, Feet],
    }
}

/// A search before the end of the field: the robot stands on its line.
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

/// A search that has begun to walk ahead to another place.
fn walking() -> Harness<Searching> {
    let mut test = search();
    scene(&mut test).carpet_ahead = 9.0;
    reaches(&mut test, "scan");
    test.tree_mut().get_mut::<SearchBall>().search_elsewhere();
    test.reaches::<SearchBall>("find_path", ms(100));
    test.stays::<SearchBall>("find_path", ms(450));
    test.reaches::<SearchBall>("walk_on", ms(150));
    test.run_for(ms(50));
    assert!(matches!(request(&test), Request::Straight { forward, .. } if forward > 0.0));
    test
}

#[test]
fn walk_ends_at_the_next_place() {
    let mut test = walking();
    scene(&mut test).walked.position.x = 0.5;
    test.stays::<SearchBall>("walk_on", ms(300));
    scene(&mut test).walked.position.x = 9.0;
    test.reaches::<SearchBall>("scan", ms(100));
}

#[test]
fn robot_in_the_way_ends_a_walk() {
    for (walked, state) in [(0.2, "find_path"), (0.3, "scan")] {
        let mut test = walking();
        scene(&mut test).walked.position.x = walked;
        test.run_for(ms(50));
        scene(&mut test).robot = Some(Vec2::new(0.3, 0.1));
        test.reaches::<SearchBall>(state, ms(100));
    }
}

#[test]
fn robot_beside_the_way_does_not_end_a_walk() {
    let mut test = walking();
    scene(&mut test).robot = Some(Vec2::new(0.3, 0.8));
    test.stays::<SearchBall>("walk_on", ms(500));
}
