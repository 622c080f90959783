//! How the program ends.

use std::fmt;
use std::io;
use std::path::Path;
use std::process::ExitCode;

/// An end that is no failure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// A goal, or what was asked is done.
    Success,
    /// No goal, or nothing that could be looked at.
    Unsuccessful,
    /// Ctrl-C.
    Interrupted,
}

impl From<Outcome> for ExitCode {
    fn from(ending: Outcome) -> Self {
        Self::from(match ending {
            Outcome::Success => 0,
            Outcome::Unsuccessful => 1,
            Outcome::Interrupted => 130,
        })
    }
}

/// Why the program cannot go on.
#[derive(Debug)]
pub enum Failure {
    /// What was wrong, and how to mend it.
    Wrong {
        /// What was found.
        what: String,
        /// What to do about it.
        mend: String,
    },
    /// Whoever read the output went away: nobody is left to complain to.
    Unheard,
}

impl Failure {
    /// Something was wrong.
    pub fn new(what: impl Into<String>, mend: impl Into<String>) -> Self {
        Self::Wrong { what: what.into(), mend: mend.into() }
    }

    /// A file or folder that the user named could not be read or written.
    pub fn of_path(done: &str, path: &Path, error: &dyn fmt::Display, mend: &str) -> Self {
        Self::new(format!("cannot {done} `{}`: {error}", path.display()), mend)
    }
}

/// An output that failed.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::Unheard,
            _ => Self::new(format!("cannot write the output: {error}"), "is the disk full?"),
        }
    }
}

impl From<Failure> for ExitCode {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Wrong { what, mend } => {
                eprint_quietly(&format!("error: {what}\n  help: {mend}\n"));
                Self::from(2)
            }
            // As a shell reports a program that the broken pipe ended.
            Failure::Unheard => Self::from(141),
        }
    }
}

fn eprint_quietly(text: &str) {
    use io::Write;
    // With stderr gone too there is nobody to tell.
    let _ = io::stderr().write_all(text.as_bytes());
}
