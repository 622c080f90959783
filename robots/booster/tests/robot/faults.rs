//! Faults of the robot.

use bica_booster::message::MotorState;
use bica_booster::{Gait, K1, T1};

use crate::stand_in::StandIn;

#[test]
fn refused_mode_is_asked_again_once_a_second() {
    let mut robot = StandIn::new(T1, Gait::Own);
    robot.status = 501;
    robot.run(5000);
    let asked = robot.asked_for(1);
    assert!((4..=5).contains(&asked.len()) && asked.windows(2).all(|pair| pair[1] - pair[0] >= 1000), "{asked:?}");
    assert!(robot.commands.is_empty());
    robot.status = 0;
    robot.run(6000);
    assert!(robot.has_gains());
}

#[test]
fn change_of_the_mode_may_take_time() {
    for transition in [50, 700, 3000] {
        let mut robot = StandIn::new(T1, Gait::Own);
        robot.transition = transition;
        robot.run(12_000);
        assert!(robot.has_gains() && robot.mode == 3, "{transition} ms: {:?}", robot.notes);
        robot.stop = true;
        robot.run_to_the_end();
    }
}

#[test]
fn mode_left_takes_the_gains_away_for_good() {
    for mode in [0, 1, 2, 4, 9] {
        let mut robot = StandIn::following(T1, Gait::Own);
        let asked = robot.requests.iter().filter(|(_, _, mode)| mode.is_some()).count();
        let at = robot.millis;
        robot.leave_to(mode);
        robot.run(30_000);
        let last = robot.commands.iter().rev().find(|(_, command)| command.motor_cmd[0].kd > 0.0);
        assert!(last.is_none_or(|(millis, _)| *millis <= at + 600), "gains are 0 within 0.6 s");
        let asked_now = robot.requests.iter().filter(|(_, _, mode)| mode.is_some()).count();
        assert_eq!(asked_now, asked, "no mode is requested without an operator");
        assert!(!robot.has_gains());
    }
}

#[test]
fn unknown_mode_takes_the_gains_away() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.is_deaf = true;
    let at = robot.millis;
    robot.run(5000);
    let (last, _) = robot.commands.iter().rfind(|(_, it)| it.motor_cmd[0].kp > 0.0).expect("there were gains");
    assert!((1000..=2000).contains(&(last - at)) && !robot.has_gains(), "{}", last - at);
    robot.is_deaf = false;
    robot.run(2000);
    assert!(robot.has_gains(), "it was custom all the time");
}

#[test]
fn states_with_mistakes_are_not_used() {
    let spoilt: [fn(&mut bica_booster::message::LowState); 3] = [
        |state| state.motor_state_serial[3].q = f32::NAN,
        |state| state.motor_state_serial.truncate(22),
        |state| state.motor_state_serial.push(MotorState::default()),
    ];
    for spoil in spoilt {
        let mut robot = StandIn::following(T1, Gait::Own);
        robot.spoil = Some(spoil);
        let (used, cycles) = (robot.driver.counts().states, robot.cycles);
        robot.run(40);
        assert!(robot.driver.counts().states == used && robot.driver.counts().rejected >= 20);
        robot.spoil = None;
        robot.run(1000);
        assert!(robot.cycles > cycles + 95 && robot.has_gains(), "a short fault has no consequence");
        let mut of_k1 = StandIn::new(K1, Gait::Own);
        of_k1.spoil = Some(spoil);
        of_k1.run(3000);
        assert!(of_k1.requests.is_empty() || of_k1.q.len() != 23);
    }
}

#[test]
fn targets_rest_without_states() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.program = |_, cycle| {
        let mut command = crate::stand_in::stand(T1);
        command.targets.0[0] = 0.5 * (0.1 * cycle as f32).sin();
        Some(command)
    };
    robot.run(500);
    robot.is_silent = true;
    robot.run(60);
    let (at, cycles) = (robot.commands.len(), robot.cycles);
    robot.run(400);
    let first = robot.commands[at].1.motor_cmd[0].q;
    assert!(robot.commands[at..].iter().all(|(_, command)| (command.motor_cmd[0].q - first).abs() < 1e-6));
    assert!(robot.cycles <= cycles + 1 && robot.has_gains() && robot.mode == 3);
    robot.is_silent = false;
    robot.run(100);
    assert!(robot.cycles > cycles + 8);
}

#[test]
fn silence_damps_and_the_robot_stands_up_again() {
    let mut robot = StandIn::following(T1, Gait::Own);
    robot.is_silent = true;
    let at = robot.millis;
    robot.run(1000);
    let damped = robot.asked_for(0)[0] - at;
    assert!((500..600).contains(&damped) && robot.mode == 0 && !robot.has_gains(), "{damped}");
    robot.run(5000);
    assert_eq!(robot.asked_for(0).len(), 1);
    robot.is_silent = false;
    let at = robot.millis;
    robot.run(8000);
    assert!(robot.asked_for(1)[1] - at >= 2000 && robot.has_gains(), "after two seconds with states");
}

#[test]
fn silence_of_everything_damps_too() {
    let mut robot = StandIn::following(T1, Gait::Own);
    (robot.is_silent, robot.is_deaf) = (true, true);
    robot.run(6000);
    assert!(!robot.has_gains() && robot.asked_for(0).len() >= 3, "{:?}", robot.asked_for(0));
}

impl StandIn {
    /// The robot leaves a mode by itself. The commands that come before the driver can know it are not judged.
    fn leave_to(&mut self, mode: i64) {
        self.tolerated = 600;
        self.mode = mode;
    }
}
