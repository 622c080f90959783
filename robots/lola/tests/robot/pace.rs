//! Robots in step and in real time, whose program is late.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use bica_lola::LolaWorld;
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_motion::robot::Command;

use crate::stand_in::{Program, RISE, StandIn};

/// Maps in which the driver measures the pace of the robot.
const MEASURED: u32 = 60;
/// Cycle in which the program of a test waits until it is released.
const BLOCKED: u32 = 10;
/// Longest wait of a test.
const LONGEST: Duration = Duration::from_secs(5);

fn turns_head(cycle: u32, _world: &mut LolaWorld) -> Command {
    let mut command = Command::new(NAO.stand, 0.8);
    command.targets[Joint::HeadYaw] = 0.02 * cycle as f32;
    command
}

/// Targets of the first cycles of a robot in step.
fn targets(robot: &mut StandIn) -> Vec<Joints> {
    let target = |_| {
        robot.cycles(1);
        robot.last.expect("an answer").0
    };
    (0..RISE + 30).map(target).collect()
}

/// A program that takes longer than a robot in real time waits.
fn late(cycle: u32, world: &mut LolaWorld) -> Command {
    thread::sleep(Duration::from_millis(20));
    turns_head(cycle, world)
}

#[test]
fn robot_in_step_waits_for_a_late_program() {
    let [prompt, late] = [turns_head as Program, late].map(|program| {
        let mut robot = StandIn::start(program);
        let targets = targets(&mut robot);
        assert_eq!(robot.late(), 0);
        targets
    });
    assert!(prompt == late && prompt[RISE + 29][Joint::HeadYaw] > 0.3);
}

#[test]
fn robot_in_real_time_is_answered_without_its_program() {
    static IS_RELEASED: AtomicBool = AtomicBool::new(false);
    fn blocked(cycle: u32, world: &mut LolaWorld) -> Command {
        let start = Instant::now();
        while cycle == BLOCKED && !IS_RELEASED.load(Ordering::Relaxed) && start.elapsed() < LONGEST {
            thread::sleep(Duration::from_millis(1));
        }
        turns_head(cycle, world)
    }
    let mut robot = StandIn::start(blocked);
    robot.cycles_in_real_time(MEASURED);
    robot.cycles(RISE - MEASURED as usize);
    // The program waits for the test, and the test for answers. On a busy computer other commands are late, too.
    let last = 0.02 * (BLOCKED - 1) as f32;
    let is_in_force = |robot: &StandIn| (robot.last.expect("an answer").0[Joint::HeadYaw] - last).abs() < 1e-6;
    let waited = (0..500).position(|_| {
        robot.cycles(1);
        is_in_force(&robot)
    });
    assert!(waited.is_some(), "the newest command never comes into force");
    robot.cycles(11);
    assert!(is_in_force(&robot), "it stays in force");
    let before = robot.late();
    assert!(before >= 10, "{before}");
    robot.cycles(20);
    assert_eq!(robot.late(), before + 20);
    IS_RELEASED.store(true, Ordering::Relaxed);
    robot.cycles_in_real_time(20);
    assert!(robot.last.expect("an answer").0[Joint::HeadYaw] > last + 0.1, "the program commands again");
    assert!(robot.is_silent());
    let standing = robot.standing.lock().expect("no panic").to_string();
    assert!(standing.contains(&format!("{} of them late", robot.late())), "{standing}");
}

#[test]
fn pace_is_measured_again_after_a_reconnection() {
    let mut robot = StandIn::start(late);
    robot.cycles_in_real_time(MEASURED);
    robot.cycles(RISE - MEASURED as usize + 20);
    let in_real_time = robot.late();
    assert!(in_real_time > 0);
    robot.map.position = NAO.sit.0;
    robot.restart();
    targets(&mut robot);
    assert_eq!(robot.late(), in_real_time);
}

#[test]
fn further_map_shows_a_robot_in_real_time() {
    let mut robot = StandIn::start(late);
    robot.cycles(RISE + 2);
    assert_eq!(robot.late(), 0);
    robot.send(&robot.map.encode().repeat(2));
    (0..2).for_each(|_| robot.answer().expect("an answer"));
    robot.cycles(10);
    assert!(robot.late() > 5, "{}", robot.late());
}
