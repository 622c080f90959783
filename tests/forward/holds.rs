//! Holds of any component that begin in the middle of a step.

use bica::prelude::*;
use bica::runner::Request;
use bica_player::Forward;
use bica_player::behaviour::Player;
use bica_player::input::{HealthMonitor, RobotState};
use bica_sim::World;
use bica_sim::setup::{Frame, Setup};

use crate::forward::game::{Game, new_game};

/// Cycles of a hold: 5 s.
const HELD: usize = 500;
/// Maximum number of cycles from the release to the goal.
const TO_GOAL: usize = 12_000;

/// Runs until the robot has stood on one foot for some cycles.
fn run_into_a_step(game: &mut Game, cycles: usize) {
    let mut on_one_foot = 0;
    while on_one_foot < cycles {
        game.cycle().expect("the image fits");
        let feet = game.robot().get::<RobotState>().feet().map(bica_motion::robot::FootPressure::total);
        on_one_foot = if feet.contains(&0.0) { on_one_foot + 1 } else { 0 };
        assert!(game.world().referee().goals() == 0, "the robot never stood on one foot");
    }
}

/// Plays a game with a hold; returns the failure at the end, if any.
fn play(component: ComponentId, hold: Hold) -> Option<String> {
    let mut game = new_game(&Setup { seed: 11, frame: Frame::Small, goalkeeper: false, ..Setup::default() });
    run_into_a_step(&mut game, 3 + component.index() % 6);
    Request::Hold { component, hold }.apply(game.robot_mut()).expect("a component of the tree");
    for _ in 0..HELD {
        game.cycle().expect("the image fits");
    }
    Request::Hold { component, hold: Hold::Tree }.apply(game.robot_mut()).expect("a component of the tree");
    let cycles = (0..TO_GOAL).take_while(|_| {
        game.cycle().expect("the image fits");
        game.world().referee().goals() == 0
    });
    let (cycles, robot) = (cycles.count(), game.robot());
    let (fault, state) = (robot.get::<HealthMonitor>().fault(), robot.of::<Player>().state_name());
    (fault.is_some() || cycles == TO_GOAL).then(|| format!("{fault:?} after {cycles} cycles in the state {state:?}"))
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_robot_recovers_after_a_hold() {
    let mut wrong = Vec::new();
    for (index, node) in Forward::GRAPH.nodes.iter().enumerate() {
        for hold in [Hold::Latent, Hold::Active] {
            let found = play(ComponentId::new(index), hold);
            wrong.extend(found.map(|found| format!("{} held {hold:?}: {found}", node.name)));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
