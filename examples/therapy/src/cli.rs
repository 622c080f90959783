//! The command line.

use std::path::PathBuf;
use std::process::ExitCode;

use bica::Params;
use bica_app::{Console, Failure, Outcome};
use clap::{Args, Parser, Subcommand};

use crate::exercise::Judging;
use crate::judge;

/// A player of therapy sessions. It is no medical device, and its stop is no certified safety function
#[derive(Debug, Parser)]
#[command(name = "therapy", arg_required_else_help = true)]
struct Program {
    #[command(subcommand)]
    command: Commands,
}

#[derive(Debug, Subcommand)]
enum Commands {
    /// Judge recorded exercises against the first three correct ones of each person
    Judge(Judge),
}

#[derive(Debug, Args)]
struct Judge {
    /// Folder with `correct/` and `incorrect/`: files `mMM_sSS_eEE_positions.txt` and `…_angles.txt`, also compressed (.gz)
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Skeletons a second
    #[arg(long, value_name = "HZ", default_value_t = 30.0, value_parser = rate)]
    rate: f32,
    /// Print a line of JSON for each recording; all other output goes to stderr
    #[arg(long)]
    json: bool,
}

fn rate(text: &str) -> Result<f32, String> {
    let rate = text.parse().ok().filter(|rate| (1.0..=240.0).contains(rate));
    rate.ok_or_else(|| "give a number from 1 to 240".to_owned())
}

/// Runs the command of the command line; returns the exit code.
#[must_use]
pub fn run() -> ExitCode {
    let Commands::Judge(args) = Program::parse().command;
    run_judge(&args).map_or_else(ExitCode::from, ExitCode::from)
}

fn run_judge(args: &Judge) -> Result<Outcome, Failure> {
    // Recordings have no times, so their tempo is not known.
    let judging = Judging { tempo: 0.0, ..Judging::DEFAULT };
    let judged = judge::judge(&args.folder, args.rate, &judging)?;
    let console = Console::new(args.json);
    for each in &judged {
        if args.json {
            console.print_json_line(each)?;
        } else {
            let (reasons, plural) = (each.reasons.join(", "), if each.repetitions == 1 { "" } else { "s" });
            console.print(&format!(
                "{}  {}  {} repetition{plural}  {reasons}",
                each.file, each.verdict, each.repetitions
            ))?;
        }
    }
    Ok(Outcome::Success)
}
