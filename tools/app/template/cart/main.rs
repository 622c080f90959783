//! The program.

use std::process::ExitCode;

fn main() -> ExitCode {
    cart::app().run()
}
