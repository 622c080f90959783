//! The maker's gait.

use bica_booster::{Gait, K1, Motion, T1};
use bica_motion::joints::Joint;
use bica_motion::robot::Command;

use crate::stand_in::StandIn;

fn count(robot: &StandIn, service: u64) -> usize {
    robot.requests.iter().filter(|(_, of, _)| *of == service).count()
}

#[test]
fn velocities_go_to_the_walking_firmware() {
    let mut robot = StandIn::following(K1, Gait::Firmware);
    assert_eq!((robot.mode, robot.commands.len()), (2, 0), "joints are not commanded");
    robot.motion = Motion { velocity: [0.5, -2.0, f32::NAN], head: [0.25, 3.0] };
    robot.program = |sensors, cycle| {
        let mut command = Command::new(K1.model.stand, 1.0);
        command.targets[Joint::LKneePitch] += 0.4 * (0.1 * cycle as f32).sin();
        // The legs of the robot rest, 0.05 rad beside the stand; those that the program sees follow it.
        let last = K1.model.stand[Joint::LKneePitch] + 0.4 * (0.1 * (cycle as f32 - 1.0)).sin();
        assert!(cycle < 700 || (sensors.angles[Joint::LKneePitch] - last).abs() < 1e-5);
        assert!((sensors.angles[Joint::HeadYaw] - 0.05).abs() < 1e-5, "the head is the robot's");
        Some(command)
    };
    robot.run(1000);
    let moved = robot.bodies.iter().rfind(|body| body.contains("vx")).expect("a velocity");
    assert!(moved.contains(r#""vx":0.5"#) && moved.contains(r#""vyaw":0.0"#), "{moved}");
    assert!(moved.contains(r#""vy":-0.4"#), "{moved}");
    assert!(robot.bodies.iter().any(|body| body.contains(r#""pitch":0.25,"yaw":1.0"#)));
    let moves = count(&robot, 2001);
    robot.run(10_000);
    assert!((15..=25).contains(&(count(&robot, 2001) - moves)), "an unchanged velocity is repeated twice a second");
}

#[test]
fn fallen_robot_gets_up_and_walks_on() {
    let mut robot = StandIn::following(T1, Gait::Firmware);
    robot.motion.velocity = [0.4, 0.0, 0.0];
    robot.run(500);
    (robot.fall, robot.mode) = (1, 0);
    robot.run(500);
    robot.fall = 2;
    robot.run(1000);
    assert_eq!((count(&robot, 2008), robot.fall), (1, 3));
    let moves = count(&robot, 2001);
    robot.run(3000);
    assert_eq!(count(&robot, 2001), moves, "no velocity while it lies");
    robot.fall = 0;
    robot.run(2000);
    assert!(robot.mode == 2 && count(&robot, 2001) > moves);
}

#[test]
fn robot_that_does_not_get_up_is_asked_again() {
    let mut robot = StandIn::following(T1, Gait::Firmware);
    for _ in 0..10 {
        robot.fall = 2;
        robot.run(1000);
    }
    assert!((4..=6).contains(&count(&robot, 2008)), "{}", count(&robot, 2008));
}

#[test]
fn other_mode_without_a_fall_ends_the_requests() {
    let mut robot = StandIn::following(T1, Gait::Firmware);
    robot.mode = 1;
    robot.tolerated = 600;
    robot.run(1000);
    let count = robot.requests.iter().filter(|(_, service, _)| *service != 2017).count();
    robot.run(10_000);
    assert_eq!(robot.requests.iter().filter(|(_, service, _)| *service != 2017).count(), count);
}

#[test]
fn silence_stops_and_damps() {
    let mut robot = StandIn::following(T1, Gait::Firmware);
    robot.motion.velocity = [0.4, 0.0, 0.0];
    robot.run(500);
    robot.is_silent = true;
    robot.run(300);
    let last = robot.bodies.iter().rfind(|body| body.contains("vx")).expect("a velocity");
    assert!(last.contains(r#""vx":0.0"#), "{last}");
    robot.run(500);
    assert_eq!(robot.mode, 0);
}

#[test]
fn end_stops_the_firmware_first() {
    let mut robot = StandIn::following(T1, Gait::Firmware);
    robot.motion.velocity = [0.4, 0.0, 0.0];
    robot.run(500);
    robot.stop = true;
    let millis = robot.run_to_the_end();
    let last = robot.bodies.iter().rfind(|body| body.contains("vx")).expect("a velocity");
    assert!(last.contains(r#""vx":0.0"#) && robot.mode == 1 && millis <= 2000, "{last}, {millis}");
}
