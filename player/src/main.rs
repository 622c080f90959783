//! The program `player`: a game of the forward in the built-in world, its tree as a drawing, its eyes on recorded images.

mod program;

use std::process::ExitCode;

fn main() -> ExitCode {
    program::run()
}
