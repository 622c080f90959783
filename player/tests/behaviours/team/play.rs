//! Striker and positions, with made-up perception.

use bica_motion::pose::Pose2;
use bica_player::behaviour::{
    Dribble, FaceBall, Fixmove, FollowBall, GoRound, LookAround, Player, SafetyGuard, SearchBall, SearchNet,
};
use bica_player::input::{RobotProfile, RobotState};
use bica_player::motion::{Head, Kicker, Request};
use bica_player::output::{CameraSelector, Motors};
use bica_player::referee::GoTo;
use bica_player::roles::{Carpet, Eye, Game, Goal, Health, Legs, Odometer, Place, Robots};
use bica_player::team::{Positioning, Role, SeenBall, TeamPlay};
use glam::Vec2;

use super::*;
use crate::made_up::Feet;
use crate::{ms, request, scene, stand};

activation_tree! {
    struct Play {
        root: TeamPlay,
        cycle_hz: 100,
        roles: {
            Ball: Scene, Goal: Scene, Place: Scene, Whereabouts: Scene, Odometer: Scene, Falls: Scene, Health: Scene, Legs: Feet,
            Robots: Scene, Carpet: Scene, Eye: Scene, Game: GameState, Ears: Whistle,
        },
        components: [
            TeamPlay, Positioning, GoTo, Player, SearchBall, FollowBall, SearchNet, LookAround, GoRound, Fixmove, Dribble,
            SafetyGuard, FaceBall, Head, Kicker, CameraSelector, Motors, RobotState, RobotProfile, GameState,
            Roles, TeamBall, TeamMates, GameController, Whistle, Scene, Feet,
        ],
    }
}

const ME: u8 = 2;

/// A player at a pose in a game, that stands on both feet. The goalkeeper has the number 1.
fn player(number: u8, at: Pose2) -> Harness<Play> {
    let mut test = Harness::of_box(Box::new(Play::new()));
    stand(&mut test);
    scene(&mut test).place = Some(at);
    let mut control = playing(12_000);
    control.teams[1].goalkeeper = 1;
    packet(&mut test, number, control, 0);
    test
}

/// A message of the striker, at the ball or where it sees none.
fn striker(player: u8, ball: Option<Vec2>) -> TeamMessage {
    TeamMessage {
        from: Identity { team: TEAM, player },
        role: Role::Striker,
        claim: 5,
        time_to_ball: ball.map(|_| 1.0),
        ball: ball.map(|at| SeenBall { at: at.into(), age: 0.0, error: 0.2 }),
        pose: [ball.map_or(0.0, |at| at.x - 0.2), 1.0, 0.0],
        interval: 60.0,
        ..TeamMessage::default()
    }
}

#[test]
fn player_alone_plays_as_the_forward() {
    let mut test = player(ME, Pose2::ORIGIN);
    test.stays::<TeamPlay>("strike", ms(3000));
    assert!(test.is_active::<Player>() && !test.is_active::<Positioning>());
}

#[test]
fn player_beside_a_striker_takes_its_position() {
    let mut test = player(ME, Pose2::new(-2.5, -1.0, 0.0));
    hear(&mut test, striker(3, Some(Vec2::new(1.0, 1.0))));
    test.reaches::<TeamPlay>("hold", ms(100));
    test.run_for(ms(200));
    assert!(!test.is_active::<Player>() && test.is_active::<Positioning>());
    assert!(matches!(request(&test), Request::Straight { .. } | Request::Turn(_)), "it walks to its place");
    let ball = striker(3, Some(Vec2::new(1.0, 1.0))).ball.expect("a ball");
    let role = test.tree().get::<Roles>().role();
    let place = bica_player::team::Formation::DEFAULT.place(role, Vec2::new(-2.5, -1.0), Some(ball.at.into()));
    scene(&mut test).place = Some(place);
    test.run_for(ms(300));
    assert!(test.tree().get::<GoTo>().arrived());
    assert_eq!(request(&test), Request::Stand);
}

#[test]
fn head_looks_at_field_and_ball_in_turn() {
    let mut test = player(ME, Pose2::new(-2.0, 0.0, 0.0));
    hear(&mut test, striker(3, Some(Vec2::ZERO)));
    scene(&mut test).shows_ball(Vec2::X * 2.0);
    for _ in 0..2 {
        test.reaches::<Positioning>("look", ms(4500));
        test.reaches::<Positioning>("watch", ms(3500));
    }
    (scene(&mut test).is_confirmed, scene(&mut test).is_lost) = (false, true);
    test.reaches::<Positioning>("look", ms(100));
}

#[test]
fn striker_walks_to_a_ball_that_others_see() {
    let mut test = player(ME, Pose2::new(-3.0, 0.0, 0.0));
    let seen = TeamMessage { role: Role::Supporter, ..striker(3, Some(Vec2::ZERO)) };
    scene(&mut test).is_lost = true;
    hear(&mut test, TeamMessage { time_to_ball: None, ..seen });
    test.reaches::<TeamPlay>("join", ms(1500));
    test.run_for(ms(200));
    assert!(matches!(request(&test), Request::Straight { forward, .. } if forward > 0.1));
    scene(&mut test).shows_ball(Vec2::X * 2.0);
    test.reaches::<TeamPlay>("strike", ms(100));
    (scene(&mut test).is_confirmed, scene(&mut test).is_lost) = (false, true);
    test.reaches::<TeamPlay>("join", ms(100));
    scene(&mut test).place = Some(Pose2::new(-0.8, 0.0, 0.0));
    test.reaches::<TeamPlay>("strike", ms(100));
    assert!(test.is_active::<Player>());
}

#[test]
fn old_sighting_of_others_is_searched_for_as_before() {
    let mut test = player(ME, Pose2::new(-3.0, 0.0, 0.0));
    scene(&mut test).is_lost = true;
    let ball = Some(SeenBall { age: 5.0, at: [0.0; 2], error: 0.2 });
    hear(&mut test, TeamMessage { role: Role::Supporter, ball, time_to_ball: None, ..striker(3, None) });
    test.run_for(ms(1000));
    test.stays::<TeamPlay>("strike", ms(3000));
}

#[test]
fn goalkeeper_plays_a_ball_near_its_goal_only() {
    let mut test = player(1, Pose2::new(-2.8, 0.0, 0.0));
    test.reaches::<TeamPlay>("hold", ms(100));
    assert_eq!(test.tree().get::<Roles>().role(), Role::Goalkeeper);
    scene(&mut test).shows_ball(Vec2::X * 2.0);
    test.stays::<TeamPlay>("hold", ms(500));
    scene(&mut test).shows_ball(Vec2::X * 0.3);
    test.reaches::<TeamPlay>("strike", ms(100));
    scene(&mut test).shows_ball(Vec2::X * 2.0);
    test.reaches::<TeamPlay>("hold", ms(100));
}

#[test]
fn one_of_two_others_defends() {
    let mut test = player(ME, Pose2::new(-1.0, 0.0, 0.0));
    hear(&mut test, striker(3, Some(Vec2::ZERO)));
    let role = |test: &Harness<Play>| test.tree().get::<Roles>().role();
    test.run_for(ms(50));
    assert_eq!(role(&test), Role::Defender, "nobody else is behind the ball");
    let behind = TeamMessage { role: Role::Supporter, pose: [-1.2, 0.0, 0.0], ..striker(4, None) };
    hear(&mut test, behind);
    test.run_for(ms(50));
    assert_eq!(role(&test), Role::Defender, "the other one leads by 0.2 m only");
    hear(&mut test, TeamMessage { pose: [-1.8, 0.0, 0.0], ..behind });
    test.run_for(ms(50));
    assert_eq!(role(&test), Role::Supporter);
    hear(&mut test, TeamMessage { role: Role::Goalkeeper, ..striker(1, None) });
    hear(&mut test, TeamMessage { role: Role::Absent, ..behind });
    test.run_for(ms(50));
    assert_eq!(role(&test), Role::Supporter, "the goalkeeper is behind it");
}

#[test]
fn way_leads_around_another_player() {
    let mut test = player(ME, Pose2::new(-2.0, 0.0, 0.0));
    let ball = Vec2::new(2.0, 0.0);
    hear(&mut test, striker(3, Some(ball)));
    let free = {
        test.run_for(ms(200));
        request(&test)
    };
    let Request::Straight { turn: before, .. } = free else { panic!("{free:?}") };
    let beside = TeamMessage { role: Role::Supporter, pose: [-1.6, 0.02, 0.0], ..striker(4, None) };
    hear(&mut test, beside);
    test.run_for(ms(50));
    let around = request(&test);
    let (Request::Straight { turn: turned, .. } | Request::Turn(turned)) = around else { panic!("{around:?}") };
    assert!((turned - before).abs() > 0.2, "{free:?} {around:?}");
}
