//! The slowest run of each component beside its budget.

use std::process::ExitCode;

fn main() -> ExitCode {
    biped::app().bench()
}
