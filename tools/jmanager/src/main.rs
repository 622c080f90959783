//! The program `jmanager`.

use std::process::ExitCode;

fn main() -> ExitCode {
    jmanager::run()
}
