//! The program `goalkeeper`.

use std::process::ExitCode;

fn main() -> ExitCode {
    goalkeeper::cli::app().run()
}
