//! Check of speed: instruction counts of the benchmarks in `benches/instructions`. They depend neither on a clock nor
//! on other programs on the machine.

mod claims;
mod count;
mod gate;
mod hardest;
mod slow;

use std::fs;

use crate::cli::Budget;
use crate::install::packages;
use crate::process::{root, run, works};

const FIGURES: &str = "benches/instructions.txt";
/// Version of Gungraun with which the benchmarks are built; its runner must have the same.
const VERSION: &str = "0.20.0";
const TOOLS: &str = "target/tools";

/// Counts, and compares with the committed figures or accepts the new ones.
///
/// # Errors
/// If an installation or a build fails, or a count changed.
pub(crate) fn check(options: &Budget) -> Result<(), String> {
    let runner = install()?;
    let counted = count::count(&runner, options.slow)?;
    let rust = count::compiler()?;
    if options.slow {
        return slow::judge(&counted, &committed()?, &rust).map(|report| println!("{report}"));
    }
    let hard = hardest::wrong(&counted);
    if !hard.is_empty() {
        return Err(format!("frames above the bound:\n  {}", hard.join("\n  ")));
    }
    let found_claims = claims::judge(&counted);
    if options.bless {
        found_claims?;
        return fs::write(root().join(FIGURES), gate::text(&counted, &rust))
            .map_err(|error| format!("cannot write {FIGURES}: {error}"));
    }
    let report = gate::compare(&committed()?, &counted, &rust)?;
    println!("{}", report.table);
    if report.wrong.is_empty() {
        println!("{}", found_claims?);
        return Ok(());
    }
    let (Ok(found) | Err(found)) = found_claims;
    println!("{found}");
    let wrong = report.wrong.join("\n  ");
    Err(format!(
        "not within 2 % of {FIGURES}:\n  {wrong}\nIf the change is intended, run `cargo xtask budget --bless` and give the reason in the commit."
    ))
}

fn committed() -> Result<String, String> {
    fs::read_to_string(root().join(FIGURES)).map_err(|error| format!("cannot read {FIGURES}: {error}"))
}

/// Installs valgrind and the runner that reads its counts; returns the runner's path.
///
/// # Errors
/// If an installation fails.
pub(crate) fn install() -> Result<String, String> {
    if !works("valgrind", &["--version"]) {
        packages(&["valgrind"])?;
    }
    let folder = format!("{TOOLS}/gungraun-{VERSION}");
    let runner = root().join(&folder).join("bin/gungraun-runner");
    if !runner.is_file() {
        eprintln!("xtask: building gungraun-runner {VERSION}, once; this takes about two minutes");
        // A debug build, because optimising takes longer than it saves.
        let install = ["install", "--quiet", "--locked", "--debug", "gungraun-runner", "--version", VERSION];
        run("cargo", &[&install[..], &["--root", &folder]].concat(), &[])?;
    }
    Ok(runner.display().to_string())
}
