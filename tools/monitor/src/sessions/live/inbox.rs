//! Inbox of a session's thread, and the reasons why a connection ends.

use std::sync::mpsc::Receiver;

use bica_link::Wakeups;

use crate::protocol::Failed;
use crate::sessions::commands::Command;

/// Received commands, and the wake-ups that end a wait for the robot.
pub(super) struct Inbox {
    pub(super) commands: Receiver<Command>,
    pub(super) wakeups: Wakeups,
}

/// Why a connection ended.
pub(super) enum Exit {
    /// The session is closed.
    Close,
    /// The world is restarted, with another seed if given.
    Restart(Option<u64>),
    /// The connection was lost.
    Lost(Failed),
    /// The wait before a new attempt is over.
    Retry,
}
