//! The development tasks of the workspace: `cargo xtask` lists them.

use std::process::ExitCode;

fn main() -> ExitCode {
    xtask::run()
}
