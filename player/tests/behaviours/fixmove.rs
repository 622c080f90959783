//! The alignment before a kick, and the kick.

use bica_motion::kick::{Kick, KickKind};
use bica_motion::side::Side;
use bica_player::behaviour::Fixmove;
use bica_player::input::{RobotProfile, RobotState};
use bica_player::motion::{KickChoice, Kicker, SideChoice};
use bica_player::output::Motors;
use bica_player::roles::{Ball, Legs, Odometer};
use bica_player::strategy::Strike;

use super::*;

activation_tree! {
    struct Kicking {
        root: Fixmove,
        cycle_hz: 100,
        roles: { Ball: Scene, Odometer: Scene, Legs: Feet },
        components: [Fixmove, Kicker, Motors, RobotState, RobotProfile, Scene, Feet],
    }
}

const STRIKE: Strike = Strike { kick: Kick { kind: KickKind::Front, foot: Side::Left }, heading: 0.0 };

/// A tree with a requested kick, and the ball at a place from which it is not yet possible.
fn requested() -> Harness<Kicking> {
    let mut test = Harness::new(Kicking::new());
    test.tree_mut().get_mut::<Fixmove>().play(STRIKE);
    scene(&mut test).shows_ball(Vec2::X * 0.3);
    test.run_for(ms(100));
    test
}

/// Puts the ball where the kick hits it, and the robot on both feet.
fn line_up(test: &mut Harness<Kicking>) {
    let error = test.tree().get::<Fixmove>().error().expect("a ball");
    let at = test.tree().get::<Scene>().ball.expect("a ball");
    scene(test).shows_ball(at - Vec2::new(error.x, error.y));
    test.tree_mut().get_mut::<Feet>().is_still = true;
}

#[test]
fn it_steps_until_the_ball_is_in_place_and_then_kicks() {
    let mut test = requested();
    assert!(matches!(request(&test), Request::Step(velocity) if velocity.forward > 0.0));
    test.stays::<Fixmove>("align", ms(1000));
    line_up(&mut test);
    test.reaches::<Fixmove>("strike", ms(500));
    test.cycle();
    assert_eq!(test.tree().get::<Kicker>().requested(), Some(STRIKE.kick));
    test.reaches::<Fixmove>("over", ms(10_000));
    test.run_for(ms(50));
    assert!(test.tree().get::<Fixmove>().done() && test.tree().get::<Fixmove>().failed_kick().is_none());
}

#[test]
fn who_cannot_line_up_steps_back_and_reports_it() {
    let mut test = requested();
    test.reaches::<Fixmove>("retreat", ms(6100));
    test.run_for(ms(50));
    assert!(matches!(request(&test), Request::Step(velocity) if velocity.forward < 0.0));
    assert_eq!(test.tree().get::<Fixmove>().failed_kick(), Some(STRIKE.kick));
    test.reaches::<Fixmove>("over", ms(2100));
    test.stays::<Fixmove>("over", ms(1000));
}

#[test]
fn a_far_ball_is_out_of_reach() {
    let mut test = requested();
    scene(&mut test).shows_ball(Vec2::X);
    test.run_for(ms(50));
    assert!(test.tree().get::<Fixmove>().out_of_reach());
}

#[test]
fn an_operator_requests_another_kick() {
    let mut test = requested();
    test.reaches::<Fixmove>("over", ms(8300));
    test.tree_mut().get_mut::<Fixmove>().kick(KickChoice::Front, SideChoice::Right, 0.0);
    test.reaches::<Fixmove>("align", ms(50));
}
