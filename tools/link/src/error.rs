//! Errors.

use std::fmt;
use std::io;

use bica_wire::message::RefusalCode;
use bica_wire::model::Invalid;

/// Reason for which an operation on a link failed.
#[derive(Debug)]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum Error {
    /// The text is no address.
    Address(String),
    /// The server listens on an address of this computer's network, and that was not allowed.
    NotLoopback(String),
    /// No connection could be made, or the server could not listen.
    Connect { address: String, error: io::Error },
    /// The connection was cut.
    Disconnected(String),
    /// The robot did not answer in time.
    Timeout(&'static str),
    /// The robot's messages are those of another version of the protocol, with another schema.
    Schema { robot: u64 },
    /// After a reconnection another robot, or another program, answered; the names of the trees.
    OtherRobot { expected: String, found: String },
    /// The lease is owned by somebody else.
    Lease,
    /// The robot's program does not offer the named service.
    NotOffered(&'static str),
    /// The robot refused a request, or a setting or argument of it: the reason for programs and for people.
    Refused { code: RefusalCode, entry: usize, text: String },
    /// The tree has nothing of this name, or a value does not fit.
    Unknown(Invalid),
    /// The robot sent a description or schema that is not valid.
    Invalid(&'static str),
}

impl Error {
    pub(crate) fn connect(address: &impl fmt::Display, error: io::Error) -> Self {
        Self::Connect { address: address.to_string(), error }
    }

    /// Returns a remedy.
    #[must_use]
    pub fn help(&self) -> String {
        match self {
            Self::Address(_) => {
                "give HOST:PORT, as 127.0.0.1:7400, or the path of a serial line, as /dev/ttyUSB0@921600"
            }
            Self::NotLoopback(_) => "use 127.0.0.1 or [::1], or allow it with --listen-anywhere: there is no password",
            Self::Connect { .. } => "is a robot serving there? its program does with `--serve ADDR`",
            Self::Disconnected(_) => "the robot's program ended, or the line is broken; run the command again",
            Self::Timeout(_) => "is the robot's program stopped, or does another program answer at this address?",
            Self::OtherRobot { .. } => "attach again",
            Self::NotOffered(_) => {
                "a simulated world that a program serves with `--serve ADDR` offers it; a microcontroller and a recording do not"
            }
            Self::Lease => "wait until the operator gives it back, or take it with --take",
            Self::Refused { code: RefusalCode::World, .. } => {
                "the command `link ADDR describe` prints what can be done in the world, and with which values"
            }
            Self::Refused { .. } => "the command `link ADDR describe` prints names, kinds and ranges",
            Self::Unknown(Invalid { help, .. }) => help,
            Self::Schema { .. } | Self::Invalid(_) => "build the robot's program and this one from the same version",
        }
        .to_owned()
    }
}

impl From<Error> for Invalid {
    fn from(error: Error) -> Self {
        Self::new(error.to_string(), error.help())
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Address(text) => write!(f, "`{text}` is not the address of a link"),
            Self::NotLoopback(address) => {
                write!(f, "{address} can be reached from other computers, and whoever reaches it controls the robot")
            }
            Self::Connect { address, error } => write!(f, "no link at {address}: {error}"),
            Self::Disconnected(reason) => write!(f, "the link was cut: {reason}"),
            Self::Timeout(what) => write!(f, "the robot did not answer in time: {what}"),
            Self::Schema { robot } => {
                write!(
                    f,
                    "the robot speaks another version of the protocol: {robot:#018x}, here {:#018x}",
                    bica_wire::SCHEMA
                )
            }
            Self::OtherRobot { expected, found } => {
                write!(f, "another program answers: tree `{found}`, before `{expected}`")
            }
            Self::NotOffered(what) => write!(f, "the robot's program does not offer {what}"),
            Self::Lease => f.write_str("another operator owns the lease"),
            Self::Refused { text, .. } => write!(f, "refused: {text}"),
            Self::Unknown(invalid) => invalid.fmt(f),
            Self::Invalid(what) => write!(f, "the robot's description is not valid: {what}"),
        }
    }
}

impl From<Invalid> for Error {
    fn from(invalid: Invalid) -> Self {
        Self::Unknown(invalid)
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Connect { error, .. } => Some(error),
            _ => None,
        }
    }
}
