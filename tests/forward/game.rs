//! Games of the forward in the kinematic world.

use bica::prelude::*;
use bica::runner::Runner;
use bica_motion::model::simulation::NAO;
use bica_player::Forward;
use bica_player::perception::GoalDetector;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;

/// Game of the forward.
pub(crate) type Game = Runner<Box<Forward>, KinematicWorld>;

/// Starts a game.
pub(crate) fn new_game(setup: &Setup) -> Game {
    let world = KinematicWorld::new(NAO, setup).expect("the setup is valid");
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
    Runner::new(robot, world)
}
