//! Falls and faults.

use bica_motion::fall::{Direction, FallState};
use bica_motion::health::Fault;
use bica_motion::joints::Joint;
use bica_player::behaviour::SafetyGuard;
use bica_player::input::{GameState, RobotState};
use bica_player::output::Motors;
use bica_player::roles::{Falls, Game, Health, Legs};

use super::*;

activation_tree! {
    struct Guarded {
        root: SafetyGuard,
        cycle_hz: 100,
        roles: { Falls: Scene, Health: Scene, Legs: Feet, Game: GameState },
        components: [SafetyGuard, Motors, RobotState, GameState, Scene, Feet],
    }
}

const HOT: Option<Fault> = Some(Fault::Hot(Joint::LKneePitch));
const STUCK: Option<Fault> = Some(Fault::Stuck(Joint::LKneePitch));
const LYING: FallState = FallState::Fallen(Direction::Front);

/// A guard with the fall and the fault given, after some cycles.
fn guard(fall: FallState, fault: Option<Fault>) -> Harness<Guarded> {
    let mut test = Harness::new(Guarded::new());
    (scene(&mut test).fall, scene(&mut test).fault) = (fall, fault);
    test
}

fn reaches(test: &mut Harness<Guarded>, state: &str) {
    test.reaches::<SafetyGuard>(state, ms(20_000));
}

#[test]
fn who_did_not_fall_stands_after_half_a_second() {
    let mut test = guard(FallState::Falling(Direction::Back), None);
    test.stays::<SafetyGuard>("brace", ms(1000));
    scene(&mut test).fall = FallState::Upright;
    reaches(&mut test, "stand");
    test.cycle();
    assert!(test.tree().get::<SafetyGuard>().stands());
}

#[test]
fn who_lies_gets_up() {
    let mut test = guard(LYING, None);
    reaches(&mut test, "get_up");
    scene(&mut test).fall = FallState::Upright;
    reaches(&mut test, "stand");
    assert_eq!(test.tree().get::<SafetyGuard>().attempts(), 1);
}

#[test]
fn after_a_failed_attempt_another_one_follows() {
    let mut test = guard(LYING, None);
    for state in ["get_up", "rest", "brace", "get_up"] {
        reaches(&mut test, state);
    }
    assert_eq!(test.tree().get::<SafetyGuard>().attempts(), 1);
}

#[test]
fn who_is_out_of_the_game_stays_down() {
    let mut test = guard(LYING, None);
    test.tree_mut().get_mut::<GameState>().stop();
    reaches(&mut test, "rest");
    test.stays::<SafetyGuard>("rest", ms(2000));
    test.tree_mut().get_mut::<GameState>().play();
    reaches(&mut test, "get_up");
}

#[test]
fn a_hot_robot_sits_until_it_has_cooled() {
    let mut test = guard(FallState::Upright, HOT);
    reaches(&mut test, "halt");
    test.stays::<SafetyGuard>("halt", ms(1000));
    assert_eq!(request(&test), Request::Stand);
    test.tree_mut().get_mut::<Feet>().is_still = true;
    reaches(&mut test, "sit");
    test.stays::<SafetyGuard>("sit", ms(5000));
    scene(&mut test).fault = None;
    reaches(&mut test, "rise");
    reaches(&mut test, "stand");
}

#[test]
fn who_cannot_halt_sits_down_after_three_seconds() {
    let mut test = guard(FallState::Upright, STUCK);
    reaches(&mut test, "halt");
    assert!(test.reaches::<SafetyGuard>("sit", ms(3200)) > ms(2900));
}

#[test]
fn a_fall_ends_a_halt_and_a_rise() {
    let mut test = guard(FallState::Upright, HOT);
    reaches(&mut test, "halt");
    scene(&mut test).fall = FallState::Falling(Direction::Left);
    reaches(&mut test, "brace");
    scene(&mut test).fall = FallState::Upright;
    test.tree_mut().get_mut::<Feet>().is_still = true;
    reaches(&mut test, "sit");
    scene(&mut test).fault = None;
    reaches(&mut test, "rise");
    scene(&mut test).fall = FallState::Falling(Direction::Left);
    reaches(&mut test, "brace");
}

#[test]
fn a_fault_ends_a_rise() {
    let mut test = guard(FallState::Upright, HOT);
    test.tree_mut().get_mut::<Feet>().is_still = true;
    reaches(&mut test, "sit");
    scene(&mut test).fault = None;
    reaches(&mut test, "rise");
    scene(&mut test).fault = HOT;
    reaches(&mut test, "halt");
}

#[test]
fn a_lasting_fault_of_a_lying_robot_lets_it_sit() {
    let mut test = guard(FallState::Falling(Direction::Front), STUCK);
    reaches(&mut test, "sit");
    test.stays::<SafetyGuard>("sit", ms(1000));
    (scene(&mut test).fall, scene(&mut test).fault) = (LYING, HOT);
    reaches(&mut test, "rest");
    scene(&mut test).fault = STUCK;
    reaches(&mut test, "sit");
}

#[test]
fn who_is_up_but_hot_sits_down() {
    let mut test = guard(LYING, None);
    reaches(&mut test, "get_up");
    (scene(&mut test).fall, scene(&mut test).fault) = (FallState::Upright, HOT);
    test.stays::<SafetyGuard>("get_up", ms(100));
    reaches(&mut test, "halt");
}
