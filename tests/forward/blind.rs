//! A robot without usable images must not walk, and must report the fault.

use bica::prelude::*;
use bica::runner::harness::{Harness, InWorld};
use bica_motion::health::Fault;
use bica_motion::joints::Joint;
use bica_player::Forward;
use bica_player::behaviour::Player;
use bica_player::input::HealthMonitor;
use bica_player::perception::{BallDetector, GoalDetector, Localization, Odometry, RobotDetector};
use bica_sim::faults::{Faults, FaultyWorld, ImageFault};
use bica_sim::setup::{Frame, Setup};

use crate::forward::game::new_game;

/// Time of the approach at which a fault begins, s.
const FROM: f32 = 7.0;

type Test = Harness<Forward, InWorld<Box<dyn bica_sim::SpectatorView>>>;

fn start(faults: Faults) -> Test {
    let setup = Setup { seed: 7, frame: Frame::Small, ..Setup::default() };
    let (robot, world, ..) = new_game(&setup).into_parts();
    let world: Box<dyn bica_sim::SpectatorView> =
        Box::new(FaultyWorld::new(Box::new(world), faults, setup.frame, setup.seed));
    Harness::of_box(robot).in_world(world)
}

/// Returns a game in which the robot walks to the ball when the fault begins.
fn approaching(faults: Faults) -> Test {
    let mut test = start(faults);
    test.until("the fault begins", Duration::from_secs(20), |test| test.now() >= Instant::from_millis(7000));
    assert_eq!(test.state::<Player>(), Some("approach"), "the seed has no approach then");
    test
}

/// True distance that the robot walks in some seconds, m.
fn walked(test: &mut Test, seconds: u64) -> f32 {
    let mut before = test.world().referee().robot().position;
    let mut way = 0.0;
    for _ in 0..seconds {
        test.run_for(Duration::from_secs(1));
        let now = test.world().referee().robot().position;
        way += now.distance(before);
        before = now;
    }
    way
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_a_robot_without_a_detector_that_runs_stands() {
    let holds: [fn(&mut Forward); 2] =
        [|robot| robot.of_mut::<BallDetector>().hold(Hold::Latent), |robot| robot.rate_mut::<BallDetector>().set(0.0)];
    for (index, hold) in holds.into_iter().enumerate() {
        let mut test = approaching(Faults::default());
        hold(test.tree_mut());
        let first = walked(&mut test, 3);
        let then = walked(&mut test, 20);
        assert!(first < 0.6 && then < 0.1, "hold {index}: {first} m, then {then} m");
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_robot_stands_while_its_camera_is_faulty() {
    for (image, fault) in [
        (ImageFault::Freeze, Fault::FrozenImage),
        (ImageFault::Dark, Fault::DarkImage),
        (ImageFault::Bright, Fault::BrightImage),
        (ImageFault::Drop, Fault::NoImages),
    ] {
        let mut test = approaching(Faults { image: Some(image), from: FROM, until: FROM + 25.0, ..Faults::default() });
        let says = |test: &Test| test.tree().get::<HealthMonitor>().sense_fault() == Some(fault);
        let after = test.until("the fault is reported", Duration::from_secs(5), says);
        let first = walked(&mut test, 3);
        let then = walked(&mut test, 15);
        assert!(first < 0.6 && then < 0.1, "{fault}: {first} m, then {then} m, reported after {after:?}");
        assert_eq!(test.state::<Player>(), Some("blind"), "{fault}");
        let goal = |test: &Test| test.world().referee().goals() > 0;
        test.until("a goal after the fault", Duration::from_secs(100), goal);
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_gyroscope_offset_is_reported_in_a_stand() {
    let mut test = start(Faults { gyro: 0.2, ..Faults::default() });
    let says = |test: &Test| test.tree().get::<HealthMonitor>().sense_fault() == Some(Fault::GyroOffset);
    test.until("the fault is reported", Duration::from_secs(20), says);
    test.run_for(Duration::from_secs(2));
    let way = walked(&mut test, 10);
    assert!(way < 0.1 && test.state::<Player>() == Some("blind"), "{way} m");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_gyroscope_offset_is_reported_in_a_walk() {
    for gyro in [0.2, -0.2] {
        let mut test = approaching(Faults { gyro, from: FROM, ..Faults::default() });
        let says = |test: &Test| test.tree().get::<HealthMonitor>().sense_fault() == Some(Fault::GyroOffset);
        test.until("the fault is reported", Duration::from_secs(5), says);
        assert_eq!(test.state::<Player>(), Some("approach"), "{gyro} rad/s");
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_stuck_head_stops_no_search() {
    for joint in [Joint::HeadYaw, Joint::HeadPitch] {
        let mut test = start(Faults { stuck: Some(joint), ..Faults::default() });
        let fault = |test: &Test| test.tree().get::<HealthMonitor>().fault() == Some(Fault::Stuck(joint));
        test.until("the joint is named", Duration::from_secs(20), fault);
        test.reaches::<Player>("fallen", Duration::from_secs(5));
    }
}

#[test]
fn estimates_of_components_that_do_not_run_are_old() {
    let mut test = start(Faults::default());
    for id in [Forward::id::<BallDetector>(), Forward::id::<GoalDetector>(), Forward::id::<RobotDetector>()] {
        test.tree_mut().at_mut(id).expect("a component").hold(Hold::Active);
    }
    test.tree_mut().of_mut::<Localization>().hold(Hold::Active);
    let known = |test: &Test| {
        let tree = test.tree();
        let ball = tree.get::<BallDetector>();
        [
            ball.is_looking(),
            ball.position().is_some() || ball.seen().is_some(),
            tree.get::<GoalDetector>().position().is_some(),
            tree.get::<Localization>().estimate().is_some(),
            tree.get::<Odometry>().is_fresh(),
        ]
    };
    let all = |test: &Test| known(test) == [true; 5];
    test.until("all estimates are known", Duration::from_secs(40), all);
    test.tree_mut().of_mut::<Player>().hold(Hold::Latent);
    for (index, id) in [
        (0, Forward::id::<BallDetector>()),
        (2, Forward::id::<GoalDetector>()),
        (3, Forward::id::<Localization>()),
        (4, Forward::id::<Odometry>()),
    ] {
        test.tree_mut().at_mut(id).expect("a component").hold(Hold::Latent);
        test.run_for(Duration::from_millis(600));
        assert!(!known(&test)[index], "{} {:?}", Forward::GRAPH.nodes[id.index()].name, known(&test));
    }
    assert_eq!(known(&test), [false; 5], "without odometry nothing relative to the robot is known");
}
