//! Commands to the thread of a session.

use std::sync::mpsc::{Sender, channel};

use bica_link::Waker;

use crate::pages::PageId;
use crate::protocol::Request;

/// What the manager asks of a session's thread.
#[derive(Debug)]
pub(super) enum Command {
    /// A request of a page.
    Operate { page: PageId, id: u32, request: Request },
    /// A person notes something: after what was asked before, such as the begin of another game.
    Note { page: PageId, id: u32, text: String },
    /// What pages watch has changed.
    Watch,
    /// A page has gone.
    Left(PageId),
    /// The session ends.
    Close,
}

/// Hands commands to a session's thread.
pub(super) struct Commands {
    commands: Sender<Command>,
    /// Ends the thread's wait for the robot.
    waker: Option<Waker>,
}

impl Commands {
    pub(super) const fn new(commands: Sender<Command>, waker: Waker) -> Self {
        Self { commands, waker: Some(waker) }
    }

    /// Commands that nobody receives.
    pub(super) fn of_nobody() -> Self {
        Self { commands: channel().0, waker: None }
    }

    /// Hands over a command; returns whether the thread still works.
    pub(super) fn send(&self, command: Command) -> bool {
        let is_sent = self.commands.send(command).is_ok();
        if let Some(waker) = &self.waker {
            waker.wake();
        }
        is_sent
    }
}
