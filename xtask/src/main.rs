//! The workspace's chores: `cargo xtask` lists them.

mod buildtime;
mod cli;
mod firmware;
mod fuzz;
mod install;
mod instructions;
mod miri;
mod mujoco;
mod no_std;
mod opencv;
mod peers;
mod process;

use std::process::ExitCode;

use clap::{CommandFactory, Parser};

use cli::{Budget, Chore, Cli, Firmware};

fn main() -> ExitCode {
    let Some(chore) = Cli::parse().chore else {
        print!("{}", Cli::command().render_help());
        return ExitCode::SUCCESS;
    };
    match done(&chore) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask: {error}");
            ExitCode::FAILURE
        }
    }
}

fn done(chore: &Chore) -> Result<(), String> {
    match chore {
        Chore::NoStd => no_std::check(),
        Chore::Firmware(asked) => firmware::check(asked),
        Chore::Mujoco => mujoco::install(),
        Chore::Budget(asked) => instructions::check(asked),
        Chore::Buildtime(asked) => buildtime::check(asked.limit),
        Chore::Fuzz(asked) => fuzz::check(asked.seconds),
        Chore::Opencv => opencv::compare(),
        Chore::Miri => miri::check(),
        Chore::Peers(asked) => peers::measure(asked),
        Chore::Ci => ci(),
    }
}

fn ci() -> Result<(), String> {
    use process::run;
    run("cargo", &["fmt", "--all", "--check"], &[])?;
    run("cargo", &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[])?;
    run("cargo", &["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "-D warnings")])?;
    run("cargo", &["test", "--workspace"], &[])?;
    peers::check()?;
    run("cargo", &["run", "--release", "--", "play", "--games", "20", "--at-least", "19"], &[])?;
    miri::check_where_possible()?;
    instructions::check(&Budget::default())?;
    mujoco::check()?;
    no_std::check()?;
    firmware::check(&Firmware::default())
}
