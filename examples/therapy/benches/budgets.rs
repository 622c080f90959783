//! The slowest run of each component of the therapy player beside its budget.

use std::process::ExitCode;

fn main() -> ExitCode {
    therapy::bench()
}
