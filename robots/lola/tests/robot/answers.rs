//! Answers in a run without faults.

use std::f32::consts::FRAC_PI_2;

use bica_lola::{LolaWorld, Reason, hip_height};
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_motion::robot::Command;

use crate::stand_in::{RISE, StandIn, stand};

#[test]
fn each_valid_map_is_answered_exactly_once() {
    let mut robot = StandIn::start(stand);
    robot.cycles(RISE + 200);
    assert!(robot.is_silent());
}

#[test]
fn robot_stands_up_slowly_from_where_it_is() {
    let mut robot = StandIn::start(stand);
    robot.cycles(20);
    assert!(robot.knee_stiffness() < 0.5);
    assert_eq!(Joints(robot.map.position), NAO.sit, "it becomes stiff where it is");
    robot.cycles(RISE);
    assert!(hip_height(&Joints(robot.map.position)) > 0.2);
    assert!(robot.knee_stiffness() > 0.7);
}

#[test]
fn wild_commands_are_limited() {
    fn wild(cycle: u32, _world: &mut LolaWorld) -> Command {
        // The stand-in checks each answer.
        let side = if cycle.is_multiple_of(3) { 3.0 } else { -3.0 };
        let mut command = Command::new(Joints::all(side), if cycle.is_multiple_of(7) { 0.0 } else { 1.0 });
        command.targets[Joint::HeadPitch] = f32::NAN;
        command
    }
    StandIn::start(wild).cycles(RISE + 500);
}

#[test]
fn head_stays_out_of_its_shell() {
    fn look_aside(_cycle: u32, _world: &mut LolaWorld) -> Command {
        let mut command = Command::new(NAO.stand, 0.8);
        (command.targets[Joint::HeadYaw], command.targets[Joint::HeadPitch]) = (FRAC_PI_2, 0.5);
        command
    }
    let mut robot = StandIn::start(look_aside);
    robot.cycles(RISE + 100);
    // 11.64° at 90°, between 11.46° at 87.49° and 18.91° at 119.52°.
    let pitch = robot.map.position[Joint::HeadPitch.index()].to_degrees();
    assert!((11.0..12.5).contains(&pitch), "{pitch}");
}

#[test]
fn standing_robot_is_not_made_limp_by_a_program() {
    fn limp(cycle: u32, _world: &mut LolaWorld) -> Command {
        Command::new(NAO.stand, if cycle < 50 { 0.8 } else { 0.0 })
    }
    let mut robot = StandIn::start(limp);
    robot.cycles(RISE + 150);
    assert!(robot.knee_stiffness() > 0.7, "{}", robot.knee_stiffness());
}

#[test]
fn measurements_have_our_units_and_signs() {
    fn check(_cycle: u32, world: &mut LolaWorld) -> Command {
        let sensors = world.sense();
        assert!((sensors.inertial.acceleration.z - 9.81).abs() < 1e-5);
        assert!(
            (sensors.left_foot.front_left - 9.81).abs() < 1e-5
                && (sensors.right_foot.rear_right - 8.0 * 9.81).abs() < 1e-3
        );
        assert_eq!((sensors.inertial.roll, sensors.inertial.pitch), (0.125, -0.25));
        assert_eq!((sensors.currents[Joint::HeadYaw], sensors.temperatures[Joint::RHand]), (0.5, 38.0));
        assert!(sensors.buttons.left_bumper && !sensors.buttons.right_bumper && !sensors.buttons.chest);
        Command::new(NAO.stand, 0.8)
    }
    let mut robot = StandIn::start(check);
    robot.map.fsr = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
    robot.map.angles = [0.125, -0.25];
    robot.map.current[0] = -0.5;
    robot.map.temperature[24] = 38.0;
    robot.map.touch[5] = 1.0;
    robot.cycles(RISE + 20);
    // A failed assertion of the program would be the reason.
    robot.stop();
    assert_eq!(robot.run_to_end().1.reason, Some(Reason::Signal));
}
