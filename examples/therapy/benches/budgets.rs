//! Slowest run of each component of the therapy player, compared with its budget.

use std::process::ExitCode;

fn main() -> ExitCode {
    therapy::bench()
}
