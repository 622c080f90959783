//! The way to joint commands, and the commands themselves.

use bica_booster::{Gait, K1, T1};
use bica_motion::joints::{Joint, Joints};
use bica_motion::robot::Command;

use crate::stand_in::{StandIn, stand};

#[test]
fn prepare_and_custom_come_before_the_first_command() {
    for body in [T1, K1] {
        let robot = StandIn::following(body, Gait::Own);
        let modes: Vec<_> = robot.requests.iter().filter_map(|(at, _, mode)| Some((*mode.as_ref()?, *at))).collect();
        let [(1, prepare), (3, custom)] = modes[..] else { panic!("{modes:?}") };
        let first = robot.commands[0].0;
        assert!(prepare + 1000 <= custom && custom < first && first <= custom + 20, "{modes:?}, {first}");
    }
}

#[test]
fn mode_is_asked_for_each_second() {
    let robot = StandIn::following(T1, Gait::Own);
    let asked: Vec<_> = robot.requests.iter().filter(|(_, service, _)| *service == 2017).map(|(at, ..)| *at).collect();
    assert!(asked.windows(2).all(|pair| pair[1] - pair[0] <= 1000) && asked.len() > 8, "{asked:?}");
}

#[test]
fn robot_stands_up_before_the_program_commands() {
    let robot = StandIn::following(K1, Gait::Own);
    for (q, joint) in robot.q.iter().zip(K1.motors) {
        // The program of the stand-in commands the stand of a T1.
        let targets = [K1.model.stand[*joint], T1.model.stand[*joint]];
        assert!(targets.iter().any(|target| (q - target).abs() < 0.02), "{joint:?}: {q}");
    }
    assert!(robot.cycles >= 200, "{}", robot.cycles);
}

#[test]
fn program_runs_at_one_hundred_hertz() {
    let mut robot = StandIn::following(T1, Gait::Own);
    let (cycles, commands) = (robot.cycles, robot.commands.len());
    robot.run(1000);
    assert!((99..=101).contains(&(robot.cycles - cycles)));
    assert!((99..=101).contains(&(robot.commands.len() - commands)));
}

#[test]
fn early_answer_after_a_late_one_waits() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.latency = |cycle| if cycle % 3 == 0 { 9 } else { 0 };
    robot.run(2000);
    let times: Vec<_> = robot.commands.iter().map(|(at, _)| *at).collect();
    assert!(times.windows(2).all(|pair| pair[1] - pair[0] >= 8), "{times:?}");
}

#[test]
fn late_looks_do_not_slow_the_cycles_down() {
    let mut robot = StandIn::following(T1, Gait::Own);
    let cycles = robot.cycles;
    for step in 0..700 {
        // A thread sleeps longer than it asks for.
        robot.run(4 + step % 2);
        robot.millis += 3;
    }
    assert!((525 - 8..=525 + 8).contains(&(robot.cycles - cycles)), "{} cycles in 5.25 s", robot.cycles - cycles);
}

#[test]
fn late_program_leaves_the_last_targets() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.program = |_, _| None;
    let (at, cycles) = (robot.commands.len(), robot.cycles);
    robot.run(3000);
    assert!(robot.cycles <= cycles + 1 && robot.driver.counts().late > 100);
    let (_, first) = &robot.commands[at];
    for (_, command) in &robot.commands[at..] {
        for (one, other) in first.motor_cmd.iter().zip(&command.motor_cmd) {
            assert!((one.q - other.q).abs() < 0.01 && other.kp > 0.0);
        }
    }
}

#[test]
fn legs_of_a_standing_robot_are_not_made_limp() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.program = |_, _| Some(Command::new(Joints::all(0.0), 0.0));
    robot.run(500);
    let (_, last) = robot.commands.last().expect("a command");
    for (joint, motor) in T1.motors.iter().zip(&last.motor_cmd) {
        assert_eq!(motor.kp > 0.0, T1.is_in_leg(*joint), "{joint:?}");
    }
    robot.rpy = [0.0, 1.4, 0.0];
    robot.run(100);
    assert!(robot.commands.last().is_some_and(|(_, last)| last.motor_cmd.iter().all(|motor| motor.kp <= 0.0)));
}

#[test]
fn invalid_commands_are_not_sent() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.program = |_, _| {
        let mut command = stand(T1);
        command.targets[Joint::LKneePitch] = f32::NAN;
        command.targets[Joint::HeadYaw] = 1.0;
        Some(command)
    };
    robot.run(500);
    let (_, last) = robot.commands.last().expect("a command");
    assert!(last.motor_cmd[0].q.abs() < 0.01, "no part of it is used");
}

#[test]
fn arms_away_from_the_body_delay_the_start() {
    let mut robot = StandIn::new(T1, Gait::Own);
    robot.q[2] = 0.9;
    robot.run(4000);
    assert_eq!(robot.asked_for(3), [0_u64; 0]);
    assert!(robot.notes.iter().any(|note| note.contains("40°")), "{:?}", robot.notes);
    robot.q[2] = 0.1;
    robot.run(500);
    assert_eq!(robot.asked_for(3).len(), 1);
}
