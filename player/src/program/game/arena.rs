//! The world that a game is played in.

use bica_motion::profile::Profile;
use bica_sim::SpectatorView;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;

use super::game_loop::Rules;
use crate::program::cli::World;
use crate::program::ending::Failure;

/// The kinds of worlds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Arena {
    /// The built-in one.
    BuiltIn,
    /// `MuJoCo`.
    #[cfg(feature = "mujoco")]
    Mujoco,
}

impl Arena {
    /// The one that is asked for; the microcontroller plays in the built-in one.
    #[cfg_attr(feature = "mujoco", expect(clippy::unnecessary_wraps, reason = "what is not built in is refused"))]
    pub(crate) fn asked(world: World) -> Result<Self, Failure> {
        match world {
            World::BuiltIn | World::Firmware => Ok(Self::BuiltIn),
            #[cfg(feature = "mujoco")]
            World::Mujoco => Ok(Self::Mujoco),
            #[cfg(not(feature = "mujoco"))]
            World::Mujoco => {
                let mend = "install its library with `cargo xtask mujoco`, then \
                            `cargo run --release --features mujoco -- play --world mujoco`";
                Err(Failure::new("this program was built without MuJoCo", mend))
            }
        }
    }

    /// How a robot moves there.
    pub(crate) const fn profile(self) -> &'static Profile {
        match self {
            Self::BuiltIn => &Profile::BUILT_IN,
            #[cfg(feature = "mujoco")]
            Self::Mujoco => &Profile::NAO,
        }
    }

    /// A world in which a game is about to start.
    pub(crate) fn open(rules: &Rules) -> Result<Box<dyn SpectatorView>, Failure> {
        let setup = Setup { seed: rules.seed, frame: rules.size, robots: rules.robots, ..Setup::default() };
        match rules.arena {
            Self::BuiltIn => {
                let world = KinematicWorld::new(&setup).map_err(|error| {
                    Failure::new(format!("no such game can be set up: {error}"), "try another --robots")
                })?;
                Ok(Box::new(world))
            }
            #[cfg(feature = "mujoco")]
            Self::Mujoco => mujoco(&setup),
        }
    }
}

#[cfg(feature = "mujoco")]
fn mujoco(setup: &Setup) -> Result<Box<dyn SpectatorView>, Failure> {
    use bica_sim::mujoco::{Error, MujocoWorld, Physics};
    let world = MujocoWorld::new(setup, &Physics::default()).map_err(|error| match &error {
        Error::Camera(what) => {
            Failure::new(format!("MuJoCo cannot draw: {what}"), "`cargo xtask mujoco` installs what that needs")
        }
        _ => Failure::new(format!("no such game can be set up: {error}"), "try another --robots"),
    })?;
    Ok(Box::new(world))
}
