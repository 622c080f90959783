//! The program `player`.

use std::process::ExitCode;

fn main() -> ExitCode {
    bica_player_program::run()
}
