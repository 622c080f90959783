//! Kicks in walking.

use bica_motion::side::Side;
use bica_player::behaviour::Dribble;
use bica_player::input::RobotProfile;
use bica_player::roles::{Ball, Goal, Legs};

use super::*;

activation_tree! {
    struct Dribbling {
        root: Dribble,
        cycle_hz: 100,
        roles: { Ball: Scene, Goal: Scene, Legs: Feet },
        components: [Dribble, RobotProfile, Scene, Feet],
    }
}

#[test]
fn a_ball_at_the_feet_is_kicked_by_the_nearer_foot() {
    let mut test = Harness::new(Dribbling::new());
    scene(&mut test).shows_ball(Vec2::new(0.4, 0.05));
    scene(&mut test).goal = Some(Vec2::new(4.0, 2.0));
    test.run_for(ms(100));
    assert!(matches!(request(&test), Request::Step(velocity) if velocity.forward > 0.0 && velocity.turn > 0.0));
    assert_eq!(test.tree().get::<Feet>().kick, None, "too far");
    scene(&mut test).shows_ball(Vec2::new(0.15, 0.05));
    test.run_for(ms(100));
    assert_eq!((test.tree().get::<Feet>().kick, test.tree().get::<Dribble>().done()), (Some(Side::Left), false));
}

#[test]
fn a_ball_that_is_far_missed_or_unknown_ends_it() {
    for ball in [Some(Vec2::X), Some(Vec2::new(0.02, 0.0)), None] {
        let mut test = Harness::new(Dribbling::new());
        scene(&mut test).ball = ball;
        test.run_for(ms(100));
        assert!(test.tree().get::<Dribble>().done(), "{ball:?}");
    }
}
