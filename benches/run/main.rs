//! `cargo bench`: the framework's own costs, vision, and the forward's components beside their budgets.
//!
//! All times are minima, which other programs on the machine hardly affect. Compare figures of one run with each other, never with
//! figures of another machine.

mod budget;
mod framework;
mod jobs;
mod vision;

use std::ffi::OsString;
use std::process::ExitCode;

const HELP: &str = "\
cargo bench                      framework, vision and budget
cargo bench -- framework         costs of visits, runs, state machines, and of more components
cargo bench -- vision            time of each stage of the vision, also on synthetic frames that are the worst for it
cargo bench -- jobs              cycles of a loop in real time, with jobs beside it and without; takes a minute
cargo bench -- budget            time of each component of the forward beside its budget; --help lists its options
--json prints a line of JSON for each table. The exit code is 1 if a budget is exceeded.

Further scripts, each with a docstring:
python3 benches/scripts/budget.py      instructions, counted by valgrind, against those that were committed
python3 benches/scripts/overhead.py    instructions of the forward's tick beyond its steps
cargo xtask peers                      the same work in other frameworks
python3 benches/vision/compare.py      the vision beside OpenCV
python3 benches/scripts/buildtime.py   compile times; newcomer.py: the first build and tests of a clone";

fn main() -> ExitCode {
    let words: Vec<OsString> = std::env::args_os().skip(1).filter(|word| word != "--bench").collect();
    let words: Vec<&str> = words.iter().filter_map(|word| word.to_str()).collect();
    let is_json = words.contains(&"--json");
    match words[..] {
        ["vision", "export", folder] => vision::export(folder.as_ref()),
        ["vision", "everything"] => vision::everything(),
        ["framework"] | ["framework", "--json"] => framework::run(is_json),
        ["jobs"] | ["jobs", "--json"] => jobs::run(is_json),
        ["vision"] | ["vision", "--json"] => vision::run(is_json, true),
        ["budget", ref options @ ..] => return budget::run(options),
        [] | ["--json"] => {
            framework::run(is_json);
            vision::run(is_json, false);
            return budget::run(&words);
        }
        _ => {
            println!("{HELP}");
            return ExitCode::from(if words == ["--help"] { 0 } else { 2 });
        }
    }
    ExitCode::SUCCESS
}
