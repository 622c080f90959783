//! `player play`: one game, or many.

use std::time::Duration;

use bica_console::{Console, Failure, Outcome};
use bica_game::{Image, Plan, Rules, WorldKind, run_one, run_series};

use crate::cli::{Play, World};

/// Plays what the command line asks for.
pub(crate) fn run(args: &Play) -> Result<Outcome, Failure> {
    let firmware = (args.world == World::Firmware).then(|| Image::new(args.image.clone(), args.size)).transpose()?;
    let rules = Rules {
        world: world(args.world)?,
        seed: args.seed,
        size: args.size,
        robots: args.robots,
        limit: Duration::from_secs_f64(args.seconds),
        realtime: args.realtime,
        firmware,
    };
    let (console, pictures) = (Console::new(args.json), args.pictures.as_deref());
    match args.games {
        None => run_one(&rules, console, pictures, args.film.as_deref()),
        Some(games) => run_series(&rules, console, pictures, &Plan::new(games, args.threads, args.at_least)),
    }
}

/// The world that is asked for; the microcontroller plays in the built-in one.
#[cfg_attr(feature = "mujoco", expect(clippy::unnecessary_wraps, reason = "what is not built in is refused"))]
fn world(world: World) -> Result<WorldKind, Failure> {
    match world {
        World::BuiltIn | World::Firmware => Ok(WorldKind::BuiltIn),
        #[cfg(feature = "mujoco")]
        World::Mujoco => Ok(WorldKind::Mujoco),
        #[cfg(not(feature = "mujoco"))]
        World::Mujoco => {
            let mend = "install its library with `cargo xtask mujoco`, then \
                        `cargo run --release --features mujoco -- play --world mujoco`";
            Err(Failure::new("this program was built without MuJoCo", mend))
        }
    }
}
