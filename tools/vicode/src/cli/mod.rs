//! The command line: `vicode model|apply|check|coverage|diff|draw|new|try`.

mod apply;
mod check;
mod compare;
#[cfg(feature = "recordings")]
mod coverage;
mod create;
mod diff;
mod draw;
mod tried;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Subcommand;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::draw::Format;

pub use self::diff::unified;

/// Commands of the command line.
#[derive(Clone, Debug, Subcommand)]
pub enum Command {
    /// Prints the model of a file as JSON
    Model {
        /// Rust source
        file: PathBuf,
        /// JSON, which is the only format
        #[arg(long)]
        json: bool,
    },
    /// Applies edits to a file, all or none
    Apply {
        /// Rust source
        file: PathBuf,
        /// File with a list of edits as JSON; `-` is the standard input
        #[arg(long)]
        edits: PathBuf,
        /// Print the difference and change nothing
        #[arg(long)]
        dry_run: bool,
    },
    /// Reports what is wrong in a file, as the macros would
    Check {
        /// Rust source
        file: PathBuf,
        /// Print the mistakes as JSON
        #[arg(long)]
        json: bool,
    },
    /// Counts in recordings and tests which states and transitions of a machine were visited, and for how long
    #[cfg(feature = "recordings")]
    Coverage {
        /// Rust source
        file: PathBuf,
        /// Recordings (MCAP), and folders that tests wrote with the variable `BICA_COVERAGE`; all are counted together
        #[arg(required = true)]
        recordings: Vec<PathBuf>,
        /// Component, if the file has several
        #[arg(long)]
        component: Option<String>,
        /// Print one line only
        #[arg(long, conflicts_with = "json")]
        summary: bool,
        /// Print the numbers as JSON
        #[arg(long)]
        json: bool,
    },
    /// Compares the state machines of two files, or of a file and its last commit
    Diff {
        /// Rust source: the first version, or the only file
        file: PathBuf,
        /// Rust source: the second version; without it `file` is compared with its version in the last commit
        other: Option<PathBuf>,
        /// Component, if several differ: only this one
        #[arg(long)]
        component: Option<String>,
        /// Draw the difference into this file
        #[arg(long, value_name = "FILE")]
        svg: Option<PathBuf>,
        /// Print the difference as JSON
        #[arg(long)]
        json: bool,
        /// End with code 1 if there is a difference
        #[arg(long)]
        exit_code: bool,
    },
    /// Draws the state machines of a file
    Draw {
        /// Rust source
        file: PathBuf,
        /// Format
        #[arg(long, value_enum, default_value_t = Format::Svg)]
        format: Format,
        /// Component, if the file has several
        #[arg(long)]
        component: Option<String>,
        /// File to write; the standard output without
        #[arg(long)]
        output: Option<PathBuf>,
    },
    /// Tries a machine without its program, and prints what was tried as a test in Rust
    Try {
        /// Rust source
        file: PathBuf,
        /// File with a list of steps as JSON; `-` is the standard input
        #[arg(long)]
        steps: PathBuf,
        /// Component, if the file has several
        #[arg(long)]
        component: Option<String>,
        /// Print states, times and ways out as JSON instead of the test
        #[arg(long)]
        json: bool,
    },
    /// Makes a new component: its file, its `mod` line, its entry in a tree
    New {
        /// Name of the component, as in `WallFinder`
        name: String,
        /// Folder of the new file
        #[arg(long, default_value = "src")]
        folder: PathBuf,
        /// Source with the `activation_tree!` that gets the component
        #[arg(long)]
        tree: Option<PathBuf>,
        /// Path of the module from which that source imports it, as in `crate::behaviour`
        #[arg(long, requires = "tree")]
        import: Option<String>,
        /// Print the differences and change nothing
        #[arg(long)]
        dry_run: bool,
    },
}

/// Runs a command, which prints to `out`; returns whether no mistake and no difference was found.
///
/// # Errors
/// If a file cannot be read or written, or an edit is refused. Nothing is changed then.
pub fn run(command: &Command, out: &mut dyn Write) -> Result<bool, String> {
    match command {
        Command::Model { file, .. } => {
            print_json(out, &crate::read(&text_of(file)?))?;
            Ok(true)
        }
        Command::Apply { file, edits, dry_run } => apply::run(file, edits, *dry_run, out),
        Command::Check { file, json } => check::run(file, *json, out),
        #[cfg(feature = "recordings")]
        Command::Coverage { file, recordings, component, summary, json } => {
            let form = match (summary, json) {
                (true, _) => coverage::Form::Line,
                (_, true) => coverage::Form::Json,
                _ => coverage::Form::Table,
            };
            coverage::run(file, recordings, component.as_deref(), form, out)
        }
        Command::Diff { file, other, component, svg, json, exit_code } => {
            let output = compare::Output { svg: svg.as_deref(), json: *json };
            let is_equal = compare::run(file, other.as_deref(), component.as_deref(), &output, out)?;
            Ok(is_equal || !exit_code)
        }
        Command::Draw { file, format, component, output } => {
            draw::run(file, *format, component.as_deref(), output.as_deref(), out)
        }
        Command::Try { file, steps, component, json } => tried::run(file, steps, component.as_deref(), *json, out),
        Command::New { name, folder, tree, import, dry_run } => {
            create::run(name, folder, tree.as_deref(), import.as_deref(), *dry_run, out)
        }
    }
}

/// Reads a file.
fn text_of(file: &Path) -> Result<String, String> {
    let failed = |error| format!("cannot read `{}`: {error}\n  help: name a Rust source file", file.display());
    fs::read_to_string(file).map_err(failed)
}

/// Reads a JSON file with a list of `what`; `-` is the standard input.
fn list_of<T: DeserializeOwned>(path: &Path, what: &str) -> Result<Vec<T>, String> {
    let failed = |error| format!("cannot read `{}`: {error}", path.display());
    let json = if path == Path::new("-") {
        std::io::read_to_string(std::io::stdin()).map_err(failed)?
    } else {
        fs::read_to_string(path).map_err(failed)?
    };
    serde_json::from_str(&json).map_err(|error| format!("`{}` is no list of {what}: {error}", path.display()))
}

fn print(out: &mut dyn Write, text: &str) -> Result<(), String> {
    out.write_all(text.as_bytes()).map_err(|error| format!("cannot print: {error}"))
}

/// Prints a value as JSON.
fn print_json(out: &mut dyn Write, value: &impl Serialize) -> Result<(), String> {
    let json = serde_json::to_string_pretty(value).map_err(|error| format!("cannot write JSON: {error}"))?;
    print(out, &(json + "\n"))
}

/// Returns line and column of a byte offset, both from 1, the column in characters.
fn place(text: &str, at: usize) -> (usize, usize) {
    let before = &text[..at.min(text.len())];
    let line = before.rfind('\n').map_or(0, |newline| newline + 1);
    (before.matches('\n').count() + 1, before[line..].chars().count() + 1)
}

/// Opens the folder of a file; returns it with the file's name.
fn folder_of(file: &Path) -> Result<(crate::Folder, String), String> {
    let name =
        file.file_name().and_then(|name| name.to_str()).ok_or_else(|| format!("`{}` is no file", file.display()))?;
    let parent = file.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    Ok((crate::Folder::open(parent).map_err(|error| error.to_string())?, name.to_owned()))
}

/// Returns the line width, in characters, of the `rustfmt.toml` that applies to a file.
#[must_use]
pub fn width_of(file: &Path) -> usize {
    let file = fs::canonicalize(file).unwrap_or_else(|_| file.to_owned());
    let configured = file.ancestors().skip(1).find_map(|folder| {
        let text =
            ["rustfmt.toml", ".rustfmt.toml"].iter().find_map(|name| fs::read_to_string(folder.join(name)).ok())?;
        Some(
            text.lines().find_map(|line| line.strip_prefix("max_width")?.trim().strip_prefix('=')?.trim().parse().ok()),
        )
    });
    configured.flatten().unwrap_or(crate::DEFAULT_WIDTH)
}
