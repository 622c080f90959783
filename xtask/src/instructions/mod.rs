//! The gate on speed: instructions of the benchmarks in `benches/instructions`, which no clock and no other program on
//! the machine can change.

mod count;
mod gate;
mod hardest;
mod promise;
mod slow;

use std::fs;

use crate::cli::Budget;
use crate::install::packages;
use crate::process::{root, run, works};

const FIGURES: &str = "benches/instructions.txt";
/// The version of Gungraun that the benchmarks are built with; its runner must be the same.
const VERSION: &str = "0.20.0";
const TOOLS: &str = "target/tools";

/// Counts, and compares with the committed figures; or takes the new ones as right.
///
/// # Errors
/// What could not be installed, built or counted, or what costs more or less than it did.
pub(crate) fn check(asked: &Budget) -> Result<(), String> {
    let runner = get()?;
    let counted = count::count(&runner, asked.slow)?;
    let rust = count::compiler()?;
    if asked.slow {
        return slow::judge(&counted, &committed()?, &rust).map(|said| println!("{said}"));
    }
    let hard = hardest::wrong(&counted);
    if !hard.is_empty() {
        return Err(format!("the eyes work too hard:\n  {}", hard.join("\n  ")));
    }
    let promises = promise::judge(&counted);
    if asked.bless {
        promises?;
        return fs::write(root().join(FIGURES), gate::text(&counted, &rust))
            .map_err(|error| format!("cannot write {FIGURES}: {error}"));
    }
    let report = gate::compare(&committed()?, &counted, &rust)?;
    println!("{}", report.table);
    if report.wrong.is_empty() {
        println!("{}", promises?);
        return Ok(());
    }
    let (Ok(found) | Err(found)) = promises;
    println!("{found}");
    let wrong = report.wrong.join("\n  ");
    Err(format!(
        "not within 2 % of {FIGURES}:\n  {wrong}\nIf that is meant, `cargo xtask budget --bless`, and say why in the commit."
    ))
}

fn committed() -> Result<String, String> {
    fs::read_to_string(root().join(FIGURES)).map_err(|error| format!("cannot read {FIGURES}: {error}"))
}

/// Valgrind, and what reads its counts.
fn get() -> Result<String, String> {
    if !works("valgrind", &["--version"]) {
        packages(&["valgrind"])?;
    }
    let folder = format!("{TOOLS}/gungraun-{VERSION}");
    let runner = root().join(&folder).join("bin/gungraun-runner");
    if !runner.is_file() {
        eprintln!("xtask: building gungraun-runner {VERSION}, once; it takes two minutes or so");
        // It only reads counts: what optimising it would take is never won back.
        let install = ["install", "--quiet", "--locked", "--debug", "gungraun-runner", "--version", VERSION];
        run("cargo", &[&install[..], &["--root", &folder]].concat(), &[])?;
    }
    Ok(runner.display().to_string())
}
