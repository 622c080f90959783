//! The chest button and an operator's stop must take the robot out of the game and back into it.

use bica::prelude::*;
use bica::runner::World;
use bica::runner::harness::{Harness, InWorld};
use bica_motion::robot::{Command, Light, Sensors};
use bica_player::Forward;
use bica_player::behaviour::{Player, SafetyGuard};
use bica_sim::Referee;
use bica_sim::World as SimulatedWorld;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use glam::Vec2;

use crate::forward::game::new_game;

/// Kinematic world with a chest button that the test presses.
struct WithButton {
    world: KinematicWorld,
    pressed: bool,
    /// The last command.
    command: Option<Command>,
}

impl World<Forward> for WithButton {
    fn now(&self) -> Instant {
        World::<Forward>::now(&self.world)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        let mut sensors = World::<Forward>::sensors(&mut self.world);
        sensors.buttons.chest = self.pressed;
        sensors
    }

    fn act(&mut self, command: &Command) {
        World::<Forward>::act(&mut self.world, command);
        self.command = Some(*command);
    }
}

type Test = Harness<Forward, InWorld<WithButton>>;

fn start() -> Test {
    let (robot, world, ..) =
        new_game(&Setup { seed: 6, frame: Frame::Small, goalkeeper: false, ..Setup::default() }).into_parts();
    Harness::of_box(robot).in_world(WithButton { world, pressed: false, command: None })
}

/// Presses the button for 0.3 s.
fn press(test: &mut Test) {
    test.world_mut().pressed = true;
    test.cycles(30);
    test.world_mut().pressed = false;
}

fn command(test: &Test) -> Command {
    test.world().command.expect("at least one cycle")
}

fn referee(test: &Test) -> &Referee {
    test.world().world.referee()
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_chest_button_stops_and_continues_the_game() {
    // The button is pressed while the robot searches, walks, and is at the ball.
    for after in [50, 400, 900, 1100, 1300, 1500, 1700] {
        let mut test = start();
        test.cycles(after);
        press(&mut test);
        test.reaches::<Player>("penalized", Duration::from_secs(7));
        test.run_for(Duration::from_secs(7));
        let (out, place) = (command(&test), referee(&test).robot().position);
        assert_eq!(out.lights.chest, Light(1.0, 0.0, 0.0));
        test.stays::<Player>("penalized", Duration::from_secs(2));
        assert_eq!(command(&test).targets, out.targets, "after {after}");
        assert!(referee(&test).robot().position.distance(place) < 1e-3, "after {after}");
        assert_eq!(referee(&test).falls(), 0, "after {after}");
        press(&mut test);
        test.cycles(20);
        assert!(test.state::<Player>().is_some_and(|state| state != "penalized"), "after {after}");
        assert_eq!(command(&test).lights.chest, Light(0.0, 1.0, 0.0));
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_stop_ends_the_game_in_a_fifth_of_a_second() {
    // The stop comes while the robot searches the ball, walks, searches the goal, and lines up. A kick ends before the
    // stop takes effect.
    for after in [50, 400, 550, 900] {
        let mut test = start();
        test.cycles(after);
        test.tree_mut().modulate("GameState", "stop", &[]).expect("a stop");
        test.reaches::<Player>("penalized", Duration::from_millis(200));
        test.run_for(Duration::from_secs(1));
        let place = referee(&test).robot().position;
        test.stays::<Player>("penalized", Duration::from_secs(5));
        assert!(referee(&test).robot().position.distance(place) < 1e-3, "after {after}");
        test.tree_mut().modulate("GameState", "play", &[]).expect("a modulation");
        test.reaches::<Player>("look_for_ball", Duration::from_millis(200));
        test.tree_mut().modulate("GameState", "stop", &[]).expect("a stop");
        test.reaches::<Player>("penalized", Duration::from_millis(200));
        press(&mut test);
        test.cycles(20);
        assert!(test.state::<Player>().is_some_and(|state| state != "penalized"), "the button, after {after}");
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_a_stopped_robot_that_falls_stays_down() {
    let mut test = start();
    test.cycles(400);
    test.tree_mut().modulate("GameState", "stop", &[]).expect("a stop");
    test.reaches::<Player>("penalized", Duration::from_millis(200));
    test.world_mut().world.add_velocity(Vec2::X * 3.0);
    test.reaches::<SafetyGuard>("rest", Duration::from_secs(5));
    test.stays::<SafetyGuard>("rest", Duration::from_secs(10));
    test.tree_mut().modulate("GameState", "play", &[]).expect("a modulation");
    test.reaches::<Player>("look_for_ball", Duration::from_secs(20));
    assert_eq!(referee(&test).falls(), 1);
}
