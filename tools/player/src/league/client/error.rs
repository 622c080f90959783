//! Errors of a connection.

use std::fmt;
use std::io;

/// Reason for which a connection or the server ended.
#[derive(Debug)]
pub(crate) enum Error {
    /// The server cannot be started: program, and error of the operating system.
    Start(String, io::Error),
    /// The server ended, or did not listen within the time limit: its last output.
    NotReady(String),
    /// A connection was refused or is broken.
    Connection(io::Error),
    /// The server closed the connection after the greeting: it does not accept the model or the number.
    Refused,
    /// A message violates the protocol: reason.
    Message(&'static str),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start(program, error) => write!(f, "the league's server `{program}` cannot be started: {error}"),
            Self::NotReady(output) => write!(f, "the league's server does not listen: {}", output.trim()),
            Self::Connection(error) => write!(f, "the connection to the league's server broke: {error}"),
            Self::Refused => {
                f.write_str("the league's server refused the player: the model or the number is not accepted")
            }
            Self::Message(what) => write!(f, "the league's server sent a message that cannot be read: {what}"),
        }
    }
}

impl std::error::Error for Error {}

impl From<io::Error> for Error {
    fn from(error: io::Error) -> Self {
        Self::Connection(error)
    }
}
