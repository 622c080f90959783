//! The command line.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use bica::{Params, Tree};
use bica_app::{App, Console, Failure, Outcome};
use clap::{Args, Subcommand};

use crate::exercise::Judging;
use crate::judge::{self, Judged};
use crate::record;
use crate::robot::Therapist;
use crate::room::Room;
use crate::script::{EXAMPLE, Problem, Script};
use crate::session::Session;

#[derive(Debug, Subcommand)]
enum Commands {
    /// Check a session: its words, and that its files exist
    Check {
        /// The session
        file: PathBuf,
    },
    /// Write a session that shows what can be said, to begin with
    New {
        /// The new file
        file: PathBuf,
    },
    /// Print a page about the records of a person
    Report(Records),
    /// Delete all records of a person
    Forget(Records),
    /// Judge recorded exercises against the first three correct ones of each person
    Judge {
        /// Folder with `correct/` and `incorrect/`: files `mMM_sSS_eEE_positions.txt` and `…_angles.txt`, also compressed (.gz)
        folder: PathBuf,
        /// Skeletons a second
        #[arg(long, value_name = "HZ", default_value_t = 30.0, value_parser = rate)]
        rate: f32,
        /// Print a line of JSON for each recording; all other output goes to stderr
        #[arg(long)]
        json: bool,
    },
}

#[derive(Debug, Args)]
struct Records {
    /// Folder of the records
    folder: PathBuf,
    /// Code of the person
    code: String,
}

fn rate(text: &str) -> Result<f32, String> {
    let rate = text.parse().ok().filter(|rate| (1.0..=240.0).contains(rate));
    rate.ok_or_else(|| "give a number from 1 to 240".to_owned())
}

const AFTER: &str = "\
Examples:
  therapy new morning.session                 write a session, to begin with
  therapy check morning.session               check it
  therapy play morning.session                play it in a simulated room
  therapy play morning.session --world mujoco the same with forces
  therapy play morning.session --page         the page of the therapist; needs the feature `monitor`
  therapy play morning.session --realtime --option sound=FOLDER     with sound
  therapy play morning.session --option code=K-27 --option records=FOLDER
  therapy report FOLDER K-27 > page.html      what was done
  therapy judge FOLDER --json                 judge recorded exercises

It is no medical device, and its stop is no certified safety function.";

/// Program of the robot with its simulated rooms. The aim of a run is the end of the session.
fn rooms() -> App<Therapist> {
    let app = App::<Therapist>::new("therapy").describe(|command| command.after_help(AFTER));
    let app = app.try_world("room", Room::open).try_world("mujoco", Room::open_with_forces);
    app.until(|robot| robot.of::<Session>().state_name() == Some("finished"))
}

/// Measures each component in the simulated room, with the session `physiotherapy`; returns the exit code.
#[must_use]
pub fn bench() -> ExitCode {
    let session = concat!("session=", env!("CARGO_MANIFEST_DIR"), "/sessions/physiotherapy.session");
    let own = ["--world", "room", "--option", session].map(OsString::from);
    rooms().bench_from(env::args_os().chain(own))
}

/// Runs the command of the command line; returns the exit code.
#[must_use]
pub fn run() -> ExitCode {
    let app = rooms().commands(|command| match command {
        Commands::Check { file } => check(&file),
        Commands::New { file } => new(&file),
        Commands::Report(Records { folder, code }) => print(&record::report(&folder, &code)?),
        Commands::Forget(Records { folder, code }) => {
            print(&format!("{code}: {} records deleted", record::forget(&folder, &code)?))
        }
        Commands::Judge { folder, rate, json } => run_judge(&folder, rate, json),
    });
    let arguments = arguments(env::args_os());
    if cfg!(not(feature = "monitor")) && arguments.get(1).is_some_and(|command| command == "monitor") {
        return Failure::new("this program was built without the page", "build it with `--features monitor`").into();
    }
    #[cfg(feature = "monitor")]
    let app = {
        let page = crate::page::Page::new(&arguments);
        if arguments.get(1).is_some_and(|command| command == "monitor")
            && let Err(failure) = page.check()
        {
            return failure.into();
        }
        app.panels(page)
    };
    app.run_from(arguments)
}

/// Replaces `play FILE` by the command `run` with the option `session`; with `--page` by the command `monitor`.
fn arguments(given: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut arguments: Vec<_> = given.collect();
    if arguments.get(1).is_some_and(|command| command == "play") {
        let page = arguments.iter().position(|argument| argument == "--page");
        let command = if page.map(|at| arguments.remove(at)).is_some() { "monitor" } else { "run" };
        let mut session = OsString::from("session=");
        arguments.get(2).into_iter().for_each(|file| session.push(file));
        arguments.splice(1..arguments.len().min(3), [command.into(), OsString::from("--option"), session]);
        if command == "monitor" {
            arguments.extend(["--option", "start=false"].map(OsString::from));
        }
    }
    arguments
}

/// Reads a session; checks its text and its sound files.
///
/// # Errors
/// If the file cannot be read or the session has errors. The message lists all errors with their places.
pub(crate) fn open(file: &Path) -> Result<Script, Failure> {
    let failed = |error| Failure::of_path("read", file, &error, "give the file of a session; `therapy new` makes one");
    let bytes = fs::read(file).map_err(failed)?;
    let told = |problems: &[Problem]| {
        let lines: Vec<_> = problems.iter().map(|problem| format!("{}:{problem}", file.display())).collect();
        Failure::new(lines.join("\n       "), "docs/therapy.md describes the session language")
    };
    let text = Script::decode(&bytes).map_err(|problem| told(&[problem]))?;
    let script = Script::parse(&text).map_err(|problems| told(&problems))?;
    let problems = script.check_files(file.parent().unwrap_or(Path::new("")));
    if problems.is_empty() { Ok(script) } else { Err(told(&problems)) }
}

/// Files of a folder, sorted by path; `help` is the remedy if the folder cannot be read.
pub(crate) fn files(folder: &Path, help: &str) -> Result<Vec<PathBuf>, Failure> {
    let failed = |error| Failure::of_path("read", folder, &error, help);
    let found = fs::read_dir(folder).map_err(failed)?.map(|entry| entry.map(|entry| entry.path()));
    let mut found = found.collect::<Result<Vec<_>, _>>().map_err(failed)?;
    found.sort();
    Ok(found)
}

fn print(text: &str) -> Result<Outcome, Failure> {
    Console::new(false).print(text)?;
    Ok(Outcome::Success)
}

fn check(file: &Path) -> Result<Outcome, Failure> {
    let script = open(file)?;
    print(&format!("{}: {} steps, {} sounds, no errors", file.display(), script.steps.len(), script.clips.len()))
}

fn new(file: &Path) -> Result<Outcome, Failure> {
    let failed = |error| Failure::of_path("create", file, &error, "choose another name, in a folder that exists");
    fs::File::create_new(file).and_then(|mut made| made.write_all(EXAMPLE.as_bytes())).map_err(failed)?;
    print(&format!("{}: change it, then run `therapy check` on it", file.display()))
}

fn run_judge(folder: &Path, rate: f32, json: bool) -> Result<Outcome, Failure> {
    // The recordings contain no times, so the tempo is not judged.
    let judging = Judging { tempo: 0.0, ..Judging::DEFAULT };
    let console = Console::new(json);
    for each in &judge::judge(folder, rate, &judging)? {
        if json {
            console.print_json_line(each)?;
        } else {
            let Judged { file, verdict, reasons, repetitions } = each;
            console.print(&format!("{file}  {verdict}  repetitions: {repetitions}  {}", reasons.join(", ")))?;
        }
    }
    Ok(Outcome::Success)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_names_no_command_that_does_not_exist() {
        let known = Commands::augment_subcommands(clap::Command::new("therapy"));
        for line in AFTER.lines().filter_map(|line| line.trim_start().strip_prefix("therapy ")) {
            let name = line.split(' ').next().unwrap_or_default();
            assert!(["play", "run"].contains(&name) || known.find_subcommand(name).is_some(), "{line}");
        }
    }
}
