//! The program `player`: games of the forward, its vision on recorded images, and the commands of every robot.
//!
//! It is a library so that other programs can play games, and a test can parse every command in the documentation.

#[cfg(any(all(feature = "lola", unix), feature = "referee"))]
mod attacked;
#[cfg(feature = "booster")]
mod booster;
#[cfg(feature = "evaluation")]
mod calibrate_camera;
mod cli;
mod colour_profile;
pub mod emulator;
#[cfg(feature = "booster")]
mod eyes;
pub mod game;
#[cfg(feature = "league")]
mod league;
#[cfg(all(feature = "lola", unix))]
mod lean;
#[cfg(all(feature = "lola", unix))]
mod lola;
mod play;
#[cfg(feature = "referee")]
mod referee;

use std::process::ExitCode;

use bica_app::App;
#[cfg(feature = "evaluation")]
use bica_evaluation::{calibrate, detection, trial_options};
use bica_player::tunable::Forward;

use cli::Command;
use colour_profile::ColourProfile;

/// Runs the program. The function is not generic, so it is compiled only once, with this library.
#[must_use]
pub fn run() -> ExitCode {
    app().run()
}

/// Returns the program.
#[must_use]
pub fn app() -> App<Forward, ColourProfile> {
    App::new("player")
        .describe(|command| command.version(env!("CARGO_PKG_VERSION")).about(cli::ABOUT).after_help(cli::AFTER))
        .kind("built-in")
        .replay(play::replay)
        .default_command(|args| play::run(&args))
        .commands(|command| match command {
            Command::Play(args) => play::run(&args),
            #[cfg(feature = "referee")]
            Command::Referee(args) => referee::command(&args),
            #[cfg(feature = "evaluation")]
            Command::Watch(args) => detection::watch(&args),
            #[cfg(feature = "evaluation")]
            Command::See(args) => detection::see(&args),
            #[cfg(feature = "evaluation")]
            Command::Calibrate(args) => calibrate::run(&args),
            #[cfg(feature = "evaluation")]
            Command::CalibrateCamera(args) => calibrate_camera::run(&args),
            #[cfg(feature = "evaluation")]
            Command::Trial(args) => trial_options::run(&args),
            #[cfg(all(feature = "lola", unix))]
            Command::Guard { socket } => lola::guard(&socket),
            #[cfg(feature = "booster")]
            Command::BoosterGuard { robot, args } => booster::guard(&robot, &args),
            #[cfg(not(feature = "referee"))]
            Command::Referee { .. } => Err(play::built_without("referee", "the small GameController")),
            #[cfg(not(feature = "evaluation"))]
            Command::Evaluation { .. } => {
                Err(play::built_without("evaluation", "recorded images, calibration and trials"))
            }
        })
}
