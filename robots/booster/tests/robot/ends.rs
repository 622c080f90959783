//! The end of a run.

use bica_booster::{Driver, Gait, T1};

use crate::stand_in::StandIn;

#[test]
fn stop_gives_a_standing_robot_to_the_firmware() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.stop = true;
    let millis = robot.run_to_the_end();
    assert!(millis <= 2000 && robot.mode == 1 && !robot.has_gains(), "{millis} ms, mode {}", robot.mode);
}

#[test]
fn stop_in_a_motion_waits_for_its_end() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.program = |_, cycle| {
        let mut command = crate::stand_in::stand(T1);
        command.targets.0[0] = 0.8 * (0.2 * cycle as f32).sin();
        Some(command)
    };
    robot.run(500);
    robot.stop = true;
    let millis = robot.run_to_the_end();
    assert!((1200..=2500).contains(&millis) && robot.mode == 1, "{millis} ms");
}

#[test]
fn stop_lets_a_lying_robot_damp() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.rpy = [0.0, 1.5, 0.0];
    robot.run(100);
    robot.stop = true;
    assert!(robot.run_to_the_end() <= 2000 && robot.mode == 0 && !robot.has_gains());
}

#[test]
fn refused_prepare_ends_with_damping() {
    let mut robot = StandIn::following(T1, Gait::Own);
    (robot.stop, robot.status) = (true, 501);
    let millis = robot.run_to_the_end();
    assert!(millis <= 5500 && !robot.asked_for(0).is_empty() && !robot.has_gains(), "{millis}");
}

#[test]
fn silent_robot_does_not_delay_the_end() {
    for delay in [0, 20, 300, 700] {
        let mut robot = StandIn::following(T1, Gait::Own);
        (robot.is_silent, robot.is_deaf) = (true, true);
        robot.run(delay);
        robot.stop = true;
        assert!(robot.run_to_the_end() <= 5500 && !robot.has_gains());
    }
}

#[test]
fn stop_is_possible_at_each_moment() {
    for millis in (0..4000).step_by(97) {
        let mut robot = StandIn::new(T1, Gait::Own);
        robot.run(millis);
        robot.stop = true;
        let took = robot.run_to_the_end();
        assert!(took <= 2500 && !robot.has_gains() && robot.mode <= 1, "at {millis} ms: {took} ms");
    }
}

#[test]
fn robot_that_was_taken_away_stays_as_it_is() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.mode = 2;
    robot.tolerated = 600;
    robot.run(2000);
    robot.stop = true;
    assert!(robot.run_to_the_end() < 10 && robot.mode == 2);
}

/// The robot of a program that was killed, and whose guard has not noticed it yet.
fn killed(gait: Gait) -> StandIn {
    let mut robot = StandIn::following(T1, gait);
    robot.motion.velocity = [0.4, 0.0, 0.0];
    robot.run(500);
    robot.driver = Driver::guarding(T1, gait, 43);
    robot
}

#[test]
fn guard_gives_a_standing_robot_to_the_firmware() {
    let mut robot = killed(Gait::Own);
    let sent = (robot.commands.len(), robot.requests.len());
    robot.run(100);
    assert_eq!((robot.commands.len(), robot.requests.len()), sent, "the guard is silent while the program lives");
    robot.stop = true;
    assert!(robot.run_to_the_end() <= 2000 && robot.mode == 1 && !robot.has_gains());
}

#[test]
fn guard_lets_a_lying_robot_damp() {
    let mut robot = killed(Gait::Own);
    robot.rpy = [0.0, 1.5, 0.0];
    robot.run(10);
    robot.stop = true;
    assert!(robot.run_to_the_end() <= 2000 && robot.mode == 0 && !robot.has_gains());
}

#[test]
fn guard_stops_a_robot_that_the_firmware_walks() {
    let mut robot = killed(Gait::Firmware);
    robot.run(1000);
    robot.stop = true;
    assert!(robot.run_to_the_end() <= 2000 && robot.mode == 1);
    let last = robot.bodies.iter().rfind(|body| body.contains("vx")).expect("a velocity");
    assert!(last.contains(r#""vx":0.0"#), "{last}");
}

#[test]
fn hanging_program_ends_after_half_a_minute() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.program = |_, _| None;
    robot.run(29_900);
    assert!(robot.has_gains() && !robot.driver.is_ending(), "a slow program goes on");
    robot.run(200);
    assert!(robot.driver.is_ending());
    assert!(robot.run_to_the_end() <= 2500 && robot.mode == 1 && !robot.has_gains());
}
