//! The chest button takes the robot out of the game and lets it in again.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::robot::{Command, Light, Sensors};
use bica_player::Forward;
use bica_player::behaviour::Player;
use bica_sim::World;
use bica_sim::setup::Setup;

use crate::game::Game;

/// Plays for some cycles with the chest button up or down.
fn play(game: &mut Game, cycles: u32, chest: bool) -> Command {
    let mut last = None;
    for _ in 0..cycles {
        let now = game.now();
        let mut buttons = game.world.sensors().buttons;
        buttons.chest = chest;
        game.robot.sense(&Sensors { buttons, ..game.world.sensors() }).expect("the eye is large enough");
        game.robot.tick(now);
        let command = game.robot.act();
        game.world.act(&command);
        last = Some(command);
    }
    last.expect("at least a cycle")
}

fn state(robot: &Forward) -> &'static str {
    let id = Forward::id::<Player>();
    let state = robot.state(id).expect("a machine");
    Forward::GRAPH.nodes[id.index()].states[state].name
}

#[test]
fn a_press_of_the_chest_button_stops_the_robot_on_its_feet_and_the_next_lets_it_play() {
    // Sent off while it looks, walks, and is at the ball.
    for after in [50, 400, 900, 1100, 1300, 1500, 1700] {
        let mut game = Game::new(&Setup { seed: 6, goalkeeper: false, ..Setup::default() });
        play(&mut game, after, false);
        play(&mut game, 30, true);
        let out = play(&mut game, 700, false);
        assert_eq!(state(&game.robot), "penalized", "after {after}");
        assert_eq!(out.lights.chest, Light(1.0, 0.0, 0.0));
        let before = game.world.referee().robot();
        let still = play(&mut game, 200, false);
        assert_eq!(still.targets, out.targets, "after {after}");
        assert!(game.world.referee().robot().position.distance(before.position) < 1e-3, "after {after}");
        assert_eq!(game.world.referee().falls(), 0, "after {after}");
        play(&mut game, 30, true);
        let back = play(&mut game, 20, false);
        assert_ne!(state(&game.robot), "penalized", "after {after}");
        assert_eq!(back.lights.chest, Light(0.0, 1.0, 0.0));
    }
}
