//! `player trial`: trials of the body in `MuJoCo`.

#[cfg(feature = "mujoco")]
use bica_app::Console;
use bica_app::{Failure, Outcome};
#[cfg(feature = "mujoco")]
use bica_evaluation::trial;
#[cfg(feature = "mujoco")]
use bica_player::Model;
#[cfg(feature = "mujoco")]
use bica_sim::mujoco::Physics;

use crate::cli::Trial;

/// Refuses: this program was built without `MuJoCo`.
#[cfg(not(feature = "mujoco"))]
pub(crate) fn run(_: &Trial) -> Result<Outcome, Failure> {
    let remedy = "install its library with `cargo xtask mujoco`, then `cargo run --release --features mujoco -- trial`";
    Err(Failure::new("this program was built without MuJoCo", remedy))
}

/// Runs the named trials.
#[cfg(feature = "mujoco")]
pub(crate) fn run(args: &Trial) -> Result<Outcome, Failure> {
    let kinds = args.names.iter().map(|name| name.0).collect();
    let &Trial { runs, seed, threads, .. } = args;
    trial::run(&trial::TrialOptions { kinds, runs, seed, threads, physics: physics(args) }, Console::new(args.json))
}

#[cfg(feature = "mujoco")]
fn physics(args: &Trial) -> Physics {
    let default = Physics { cameras: false, ..Physics::of::<Model>() };
    Physics {
        friction: args.friction.unwrap_or(default.friction),
        leg_gain: args.leg_gain.unwrap_or(default.leg_gain),
        torque_limit: args.torque_limit.unwrap_or(default.torque_limit),
        dead_time: args.dead_time.unwrap_or(default.dead_time),
        noise: args.noise.unwrap_or(default.noise),
        ..default
    }
}
