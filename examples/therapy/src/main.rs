//! The program.

use std::process::ExitCode;

fn main() -> ExitCode {
    therapy::cli::run()
}
