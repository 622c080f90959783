//! Worlds for games.

use bica_app::Failure;
use bica_player::Model;
use bica_sim::SpectatorView;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;

use crate::game::rules::{Rules, WorldKind};

/// Makes a world at the start of a game.
pub(crate) fn open(rules: &Rules) -> Result<Box<dyn SpectatorView>, Failure> {
    let setup = Setup { seed: rules.seed, frame: rules.size, robots: rules.robots, ..Setup::default() };
    match rules.world {
        WorldKind::BuiltIn => {
            let world = KinematicWorld::<Model>::new(&setup).map_err(|error| {
                Failure::new(format!("the game cannot be set up: {error}"), "try another number of --robots")
            })?;
            Ok(Box::new(world))
        }
        #[cfg(feature = "mujoco")]
        WorldKind::Mujoco => mujoco(&setup),
    }
}

#[cfg(feature = "mujoco")]
fn mujoco(setup: &Setup) -> Result<Box<dyn SpectatorView>, Failure> {
    use bica_sim::mujoco::{Error, MujocoWorld, Physics};
    let world = MujocoWorld::<Model>::new(setup, &Physics::of::<Model>()).map_err(|error| match &error {
        Error::Camera(what) => {
            Failure::new(format!("MuJoCo cannot draw: {what}"), "`cargo xtask mujoco` installs what that needs")
        }
        _ => Failure::new(format!("the game cannot be set up: {error}"), "try another number of --robots"),
    })?;
    Ok(Box::new(world))
}
