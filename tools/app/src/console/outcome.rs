//! Regular ends of a command.

use std::process::ExitCode;

use super::interrupt;

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

impl Outcome {
    /// Returns the end of a command that has reached its goal, or has not; after a request to end the program it counts as interrupted.
    #[must_use]
    pub fn of(has_succeeded: bool) -> Self {
        match has_succeeded {
            _ if interrupt::requested() => Self::Interrupted,
            true => Self::Success,
            false => Self::Unsuccessful,
        }
    }
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
