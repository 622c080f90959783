//! Times who does the same work, beside each other, and judges what was promised. `peers --help` says how.

mod child;
mod parent;

use std::process::ExitCode;

const HELP: &str = "\
Times the same work in BICA and its peers, counts heap allocations, weighs programs, and judges what was promised.

  --quick   a look: one process, few rounds; too few to judge by
  --slow    a look at BICA made slower on purpose: every promise about time must break

Ends with 1 if a promise is broken, with 2 if it could not be judged.
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
