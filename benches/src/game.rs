//! The forward in the kinematic world.

use bica::Has;
use bica::runner::{Robot, Runner};
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{Command, Sensors};
use bica_player::input::FrameTooLarge;
use bica_player::perception::{GoalDetector, Localization};
use bica_player::{Forward, tunable};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;

/// A game of the forward.
pub type Game<T = Forward> = Runner<Box<T>, KinematicWorld>;

/// Tree of the forward: with constant parameters, or tunable.
pub trait ForwardTree:
    for<'a> Robot<Sensors<'a> = Sensors<'a>, Command = Command, Error = FrameTooLarge>
    + Has<GoalDetector>
    + Has<Localization>
{
    /// Creates the tree at the start of a game.
    fn create() -> Box<Self>;
}

impl ForwardTree for Forward {
    fn create() -> Box<Self> {
        Box::new(Self::new())
    }
}

impl ForwardTree for tunable::Forward {
    fn create() -> Box<Self> {
        Box::new(Self::new())
    }
}

/// Starts a game.
///
/// # Panics
/// If the setup is not valid.
#[must_use]
pub fn new_game<T: ForwardTree>(setup: &Setup) -> Game<T> {
    let world = KinematicWorld::new(NAO, setup).expect("a valid setup");
    let mut robot = T::create();
    robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
    Runner::new(robot, world)
}
