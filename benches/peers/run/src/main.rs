//! Compares BICA with other designs on the same workloads and checks the performance claims. `peers --help` lists the
//! options.

mod child;
mod parent;

use std::process::ExitCode;

const HELP: &str = "\
Measures the same workloads in BICA and other designs: time, heap allocations, program size. Checks the performance claims.

  --quick   one process, few rounds: a preview, too short for reliable verdicts
  --slow    like --quick, with an artificial slowdown of BICA: every claim about time must fail

Exit status: 1 if a claim does not hold, 2 if the measurement failed.
";

fn main() -> ExitCode {
    let mut options = parent::Options { quick: false, slow: false };
    let mut rounds = None;
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--quick" => options.quick = true,
            "--slow" => options.slow = true,
            child::OPTION => rounds = words.next().and_then(|number| number.parse().ok()),
            _ => {
                print!("{HELP}");
                return if word == "--help" { ExitCode::SUCCESS } else { ExitCode::from(2) };
            }
        }
    }
    let result = match rounds {
        Some(rounds) => child::run(rounds, options.slow).map(|()| true),
        None => parent::run(&options),
    };
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("peers: {error}");
            ExitCode::from(2)
        }
    }
}
