//! The way around the ball.

use bica_player::behaviour::GoRound;
use bica_player::roles::{Ball, Legs, Odometer};

use super::*;

activation_tree! {
    struct Circling {
        root: GoRound,
        cycle_hz: 100,
        roles: { Ball: Scene, Odometer: Scene, Legs: Feet },
        components: [GoRound, Scene, Feet],
    }
}

#[test]
fn a_turn_to_the_left_steps_to_the_right() {
    let mut test = Harness::new(Circling::new());
    test.tree_mut().get_mut::<GoRound>().turn_by(1.0);
    scene(&mut test).shows_ball(Vec2::X * 0.24);
    test.run_for(ms(100));
    assert!(matches!(request(&test), Request::Step(velocity) if velocity.left < 0.0 && velocity.turn > 0.0));
    scene(&mut test).ball = None;
    test.run_for(ms(100));
    assert_eq!(request(&test), Request::Stand, "without a ball");
}

#[test]
fn a_turn_ends_when_the_odometry_has_turned() {
    let mut test = Harness::new(Circling::new());
    test.tree_mut().get_mut::<GoRound>().turn_by(1.0);
    scene(&mut test).shows_ball(Vec2::X * 0.24);
    for (heading, done) in [(0.0, false), (0.5, false), (0.95, true)] {
        scene(&mut test).walked.heading = heading;
        test.run_for(ms(100));
        assert_eq!(test.tree().get::<GoRound>().done(), done, "{heading}");
    }
}
