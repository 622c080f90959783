//! The forward in the kinematic world.

use bica::Tree;
use bica::runner::Runner;
use bica_player::Forward;
use bica_player::perception::GoalDetector;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;

/// A game of the forward.
pub type Game = Runner<Box<Forward>, KinematicWorld>;

/// Starts a game.
///
/// # Panics
/// If the setup is not valid.
#[must_use]
pub fn new_game(setup: &Setup) -> Game {
    let world = KinematicWorld::new(setup).expect("a valid setup");
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
    Runner::new(robot, world)
}
