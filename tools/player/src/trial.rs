//! `player trial`: trials of the body in `MuJoCo`.

use bica_console::{Console, Failure, Outcome};
use bica_evaluation::trial;
use bica_sim::mujoco::Physics;

use crate::cli::Trial;

/// Runs the named trials.
pub(crate) fn run(args: &Trial) -> Result<Outcome, Failure> {
    let kinds = args.names.iter().map(|name| name.0).collect();
    let &Trial { runs, seed, threads, .. } = args;
    trial::run(&trial::TrialOptions { kinds, runs, seed, threads, physics: physics(args) }, Console::new(args.json))
}

fn physics(args: &Trial) -> Physics {
    let default = Physics { cameras: false, ..Physics::default() };
    Physics {
        friction: args.friction.unwrap_or(default.friction),
        leg_gain: args.leg_gain.unwrap_or(default.leg_gain),
        torque_limit: args.torque_limit.unwrap_or(default.torque_limit),
        dead_time: args.dead_time.unwrap_or(default.dead_time),
        noise: args.noise.unwrap_or(default.noise),
        ..default
    }
}
