//! The program.

use std::process::ExitCode;

fn main() -> ExitCode {
    biped::app().run()
}
