//! Ends of a run.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use bica_lola::{LolaWorld, Reason, SITTING_HEIGHT, hip_height};
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_motion::robot::Command;

use crate::stand_in::{Program, RISE, StandIn, stand};

/// Runs a standing robot, lets something happen, and checks that it sits before its joints become limp, and when.
fn sits_after(program: Program, happens: impl Fn(&mut StandIn), most: usize) -> Reason {
    let mut robot = StandIn::start(program);
    robot.cycles(RISE + 50);
    happens(&mut robot);
    sits(&mut robot, most)
}

fn sits(robot: &mut StandIn, most: usize) -> Reason {
    let mut was_limp = false;
    let mut cycles = 0;
    while robot.cycle().is_some() {
        let height = hip_height(&Joints(robot.map.position));
        let is_limp = robot.knee_stiffness() <= 0.0;
        assert!(!is_limp || height <= SITTING_HEIGHT, "limp with the hips at {height} m");
        (was_limp, cycles) = (is_limp, cycles + 1);
        assert!(cycles <= most, "it takes more than {most} maps");
    }
    assert!(was_limp, "it stays stiff");
    let (_, standing) = robot.run_to_end();
    assert!(standing.is_low);
    standing.reason.expect("a reason")
}

#[test]
fn request_to_end_lets_the_robot_sit_down() {
    assert_eq!(sits_after(stand, |robot| robot.stop(), 500), Reason::Signal);
}

#[test]
fn request_to_end_while_rising_lets_it_sit_again() {
    let mut robot = StandIn::start(stand);
    robot.cycles(180);
    robot.stop();
    assert_eq!(sits(&mut robot, 500), Reason::Signal);
}

#[test]
fn held_chest_button_lets_the_robot_sit_down() {
    assert_eq!(sits_after(stand, |robot| robot.map.touch[0] = 1.0, 750), Reason::ChestButton);
}

#[test]
fn low_battery_lets_the_robot_sit_down() {
    assert_eq!(sits_after(stand, |robot| robot.map.battery[0] = 0.04, 600), Reason::LowBattery);
}

#[test]
fn critical_joint_lets_the_robot_sit_down() {
    let hot = Reason::HotJoint(Joint::RKneePitch);
    assert_eq!(sits_after(stand, |robot| robot.map.status[Joint::RKneePitch.index()] = 3, 500), hot);
}

#[test]
fn panic_of_the_program_lets_the_robot_sit_down() {
    fn panics(cycle: u32, _world: &mut LolaWorld) -> Command {
        assert!(cycle < 30, "the program of this test panics");
        Command::new(NAO.stand, 0.8)
    }
    let mut robot = StandIn::start(panics);
    robot.cycles(220);
    assert_eq!(sits(&mut robot, 400), Reason::Panic);
}

/// A program that stands for 30 cycles, and hangs then.
fn hangs(cycle: u32, _world: &mut LolaWorld) -> Command {
    if cycle == 30 {
        // Longer than the driver waits in these tests; the test waits for this thread at its end.
        thread::sleep(Duration::from_millis(1500));
    }
    Command::new(NAO.stand, 0.8)
}

#[test]
fn hanging_program_lets_the_robot_sit_down() {
    static IS_ABANDONED: AtomicBool = AtomicBool::new(false);
    let mut robot = StandIn::start_with(hangs, |options| {
        options.patience = Duration::from_millis(300);
        options.abandon = || IS_ABANDONED.store(true, Ordering::Relaxed);
    });
    robot.cycles(220);
    assert_eq!(sits(&mut robot, 400), Reason::Hangs);
    assert!(IS_ABANDONED.load(Ordering::Relaxed), "nobody ends the process");
}

#[test]
fn hanging_program_is_noticed_in_real_time() {
    let mut robot = StandIn::start_with(hangs, |options| options.patience = Duration::from_millis(300));
    robot.cycles_in_real_time(60);
    robot.cycles(RISE - 60 + 50);
    assert!(robot.late() > 0);
    assert_eq!(sits(&mut robot, 400), Reason::Hangs);
}

#[test]
fn signal_does_not_wait_for_a_hanging_program() {
    let mut robot = StandIn::start(hangs);
    robot.cycles(220);
    robot.stop();
    assert!(matches!(sits(&mut robot, 400), Reason::Hangs | Reason::Signal));
}

#[test]
fn end_of_the_time_lets_the_robot_sit_down() {
    let mut robot = StandIn::start_with(stand, |options| options.limit = Some(4.0));
    robot.cycles(300);
    assert_eq!(sits(&mut robot, 500), Reason::TimeUp);
}

#[test]
fn program_can_end_its_motion_before_the_robot_sits() {
    fn moves(cycle: u32, world: &mut LolaWorld) -> Command {
        let mut command = Command::new(NAO.stand, 0.8);
        if !world.sense().buttons.chest {
            command.targets[Joint::LHipRoll] = 0.1 * (cycle as f32 * 0.2).sin();
        }
        command
    }
    let mut robot = StandIn::start_with(moves, |options| options.halt = |_, buttons, _| buttons.chest = true);
    robot.cycles(RISE + 50);
    robot.stop();
    // 25 cycles at rest after the motion, and 2 s of sitting down; without a halt it takes 100 cycles before that.
    assert_eq!(sits(&mut robot, 240), Reason::Signal);
}

#[test]
fn robot_that_cannot_sit_keeps_its_stiffness() {
    let mut robot = StandIn::start(stand);
    robot.cycles(RISE + 50);
    robot.stop();
    let stuck = robot.map.position;
    while robot.cycle().is_some() {
        robot.map.position = stuck;
        assert!(robot.knee_stiffness() > 0.5);
    }
    assert!(!robot.run_to_end().1.is_low);
}

#[test]
fn restarted_robot_sits_down_too() {
    let mut robot = StandIn::start(stand);
    robot.cycles(RISE + 50);
    robot.stop();
    robot.cycles(60);
    robot.restart();
    assert_eq!(sits(&mut robot, 400), Reason::Signal);
}
