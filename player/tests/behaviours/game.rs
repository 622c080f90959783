//! The root: each state and transition of the player, with its own children.

use bica_motion::fall::{Direction, FallState};
use bica_motion::robot::CameraId;
use bica_player::behaviour::{
    Dribble, FaceBall, Fixmove, FollowBall, GoRound, LookAround, Player, SafetyGuard, SearchBall, SearchNet,
};
use bica_player::input::{GameState, RobotProfile, RobotState};
use bica_player::motion::{Head, Kicker};
use bica_player::output::{CameraSelector, Motors};
use bica_player::perception::Bearing;
use bica_player::roles::{self, Ball, Carpet, Eye, Falls, Goal, Health, Legs, Odometer, Place, Robots};

use super::*;

activation_tree! {
    struct Game {
        root: Player,
        cycle_hz: 100,
        roles: {
            Ball: Scene, Goal: Scene, Place: Scene, Odometer: Scene, Falls: Scene, Health: Scene, Legs: Feet,
            Robots: Scene, Carpet: Scene, Eye: Scene, roles::Game: GameState,
        },
        components: [
            Player, SearchBall, FollowBall, SearchNet, LookAround, GoRound, Fixmove, Dribble, SafetyGuard, FaceBall,
            Head, Kicker, CameraSelector, Motors, RobotState, RobotProfile, GameState,
            Scene, Feet,
        ],
    }
}

/// A game of a robot that stands on both feet.
fn game() -> Harness<Game> {
    let mut test = Harness::of_box(Box::new(Game::new()));
    stand(&mut test);
    test
}

fn reaches(test: &mut Harness<Game>, state: &str) {
    test.reaches::<Player>(state, ms(20_000));
}

/// A game in which the robot has reached the ball, and searches for the goal.
fn at_the_ball(goal: Option<Vec2>) -> Harness<Game> {
    let mut test = game();
    scene(&mut test).shows_ball(Vec2::new(0.2, 0.0));
    scene(&mut test).bearing = Some(Bearing { pan: 0.0, down: 1.1 });
    (scene(&mut test).camera, scene(&mut test).goal) = (Some(CameraId::Bottom), goal);
    scene(&mut test).goal_is_complete = goal.is_some();
    reaches(&mut test, "search_net");
    test
}

#[test]
fn it_looks_for_the_ball_walks_to_it_and_looks_again() {
    let mut test = game();
    test.stays::<Player>("look_for_ball", ms(1000));
    scene(&mut test).shows_ball(Vec2::X * 2.0);
    reaches(&mut test, "approach");
    test.stays::<Player>("approach", ms(500));
    scene(&mut test).is_lost = true;
    scene(&mut test).is_confirmed = false;
    reaches(&mut test, "look_for_ball");
}

#[test]
fn a_ball_before_a_far_goal_is_dribbled() {
    let mut test = game();
    scene(&mut test).shows_ball(Vec2::new(0.4, 0.0));
    scene(&mut test).goal = Some(Vec2::new(4.0, 0.0));
    reaches(&mut test, "dribble");
    scene(&mut test).shows_ball(Vec2::X * 1.5);
    reaches(&mut test, "approach");
}

#[test]
fn a_goal_ahead_is_shot_at_and_a_failed_kick_is_kept() {
    let mut test = at_the_ball(Some(Vec2::new(2.0, 0.0)));
    reaches(&mut test, "kick");
    assert!(test.tree().get::<Player>().plan().is_some());
    reaches(&mut test, "look_for_ball");
    assert!(test.tree().get::<Player>().last_failed_kick().is_some());
}

#[test]
fn a_ball_that_moves_away_or_is_lost_ends_a_kick() {
    let mut test = at_the_ball(Some(Vec2::new(2.0, 0.0)));
    reaches(&mut test, "kick");
    scene(&mut test).shows_ball(Vec2::X);
    reaches(&mut test, "approach");
    let mut test = at_the_ball(Some(Vec2::new(2.0, 0.0)));
    reaches(&mut test, "kick");
    scene(&mut test).is_lost = true;
    assert!(test.reaches::<Player>("look_for_ball", ms(1700)) > ms(1400));
}

#[test]
fn go_round_ends_at_the_turn_of_the_odometry() {
    let mut test = at_the_ball(None);
    reaches(&mut test, "go_round");
    let angle = test.tree().get::<GoRound>().angle();
    for part in 1..=10 {
        scene(&mut test).walked.heading = angle * part as f32 / 10.0;
        test.run_for(ms(60));
    }
    test.reaches::<Player>("search_net", ms(100));
}

#[test]
fn who_cannot_go_round_searches_the_goal_again() {
    let mut test = at_the_ball(None);
    reaches(&mut test, "go_round");
    assert!(test.reaches::<Player>("search_net", ms(25_200)) > ms(24_000));
}

#[test]
fn a_ball_lost_while_going_round_is_looked_for() {
    let mut test = at_the_ball(None);
    reaches(&mut test, "go_round");
    scene(&mut test).is_lost = true;
    assert!(test.reaches::<Player>("look_for_ball", ms(1700)) > ms(1400));
}

#[test]
fn an_unknown_ball_ends_the_search_for_the_goal() {
    let mut test = at_the_ball(None);
    scene(&mut test).ball = None;
    reaches(&mut test, "look_for_ball");
}

#[test]
fn it_stands_while_nobody_looks() {
    let mut test = game();
    test.run_for(ms(300));
    scene(&mut test).is_looking = false;
    reaches(&mut test, "blind");
    assert_eq!(request(&test), Request::Stand);
    scene(&mut test).is_looking = true;
    reaches(&mut test, "look_for_ball");
}

#[test]
fn it_stands_while_it_is_penalized() {
    let mut test = game();
    test.tree_mut().get_mut::<GameState>().stop();
    reaches(&mut test, "penalized");
    test.stays::<Player>("penalized", ms(500));
    test.tree_mut().get_mut::<GameState>().play();
    reaches(&mut test, "look_for_ball");
}

#[test]
fn guard_controls_the_body_after_a_fall_or_fault() {
    let mut test = game();
    scene(&mut test).fall = FallState::Falling(Direction::Front);
    reaches(&mut test, "fallen");
    scene(&mut test).fall = FallState::Upright;
    reaches(&mut test, "look_for_ball");
    scene(&mut test).must_stop = true;
    reaches(&mut test, "fallen");
    scene(&mut test).must_stop = false;
    reaches(&mut test, "look_for_ball");
}
