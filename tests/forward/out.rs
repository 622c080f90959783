//! The chest button takes the robot out of the game and back into it.

use bica::prelude::*;
use bica::runner::World;
use bica::runner::harness::{Harness, InWorld};
use bica_motion::robot::{Command, Light, Sensors};
use bica_player::behaviour::Player;
use bica_player::{Forward, Model};
use bica_sim::Referee;
use bica_sim::World as SimulatedWorld;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

use crate::forward::game::new_game;

/// The kinematic world with a hand on the chest button.
struct WithButton {
    world: KinematicWorld<Model>,
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
