//! A tick never allocates.

use bica::prelude::*;
use bica::runner::Robot;
use bica_sim::World;
use bica_sim::setup::Setup;

use crate::game::Game;

#[test]
fn a_whole_game_of_ticks_allocates_nothing() {
    let mut game = Game::new(&Setup { seed: 1, robots: 2, ..Setup::default() });
    for cycle in 0..6000 {
        let now = game.now();
        let sensors = game.world.sensors();
        let robot = &mut game.robot;
        let mut command = None;
        let counted = allocation_counter::measure(|| {
            if robot.sense(&sensors).is_ok() {
                robot.tick(now);
                command = Some(robot.act());
            }
        });
        assert_eq!(counted.count_total, 0, "in cycle {cycle}");
        game.world.act(&command.expect("the eye is large enough"));
    }
}
