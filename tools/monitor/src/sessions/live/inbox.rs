//! What a session's thread waits for, and why it stops to work with a connection.

use std::sync::mpsc::Receiver;

use bica_link::Wakeups;

use crate::protocol::Failed;
use crate::sessions::commands::Command;

/// Commands that have come, and the end of waits for the robot.
pub(super) struct Inbox {
    pub(super) commands: Receiver<Command>,
    pub(super) wakeups: Wakeups,
}

/// Why a connection ended.
pub(super) enum Exit {
    /// The session is closed.
    Close,
    /// A world begins again.
    Restart(Option<u64>),
    /// The connection was lost.
    Lost(Failed),
    /// The time of waiting is over.
    Retry,
}
