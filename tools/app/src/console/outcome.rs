//! Regular ends of a command.

use std::process::ExitCode;

/// Result of a command that ended without an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The command reached its goal: exit code 0.
    Success,
    /// The command ran, but a game ended without a goal or no image could be read: exit code 1.
    Unsuccessful,
    /// Ctrl-C: exit code 130.
    Interrupted,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(match outcome {
            Outcome::Success => 0,
            Outcome::Unsuccessful => 1,
            Outcome::Interrupted => 130,
        })
    }
}
