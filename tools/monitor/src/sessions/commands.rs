//! Commands to the thread of a session.

use std::sync::mpsc::{Sender, channel};

use bica_link::Waker;

use crate::pages::PageId;
use crate::protocol::Request;

/// A command of the manager to a session's thread.
#[derive(Debug)]
pub(super) enum Command {
    /// A request of a page.
    Operate { page: PageId, id: u32, request: Request },
    /// A note of a person. It is handled after earlier requests, such as a restart.
    Note { page: PageId, id: u32, text: String },
    /// The watches of the pages have changed.
    Watch,
    /// A page was closed.
    Left(PageId),
    /// The session ends.
    Close,
}

/// Sender of commands to a session's thread.
pub(super) struct Commands {
    commands: Sender<Command>,
    /// Ends the thread's wait for the robot.
    waker: Option<Waker>,
}

impl Commands {
    pub(super) const fn new(commands: Sender<Command>, waker: Waker) -> Self {
        Self { commands, waker: Some(waker) }
    }

    /// Creates a sender without a receiver.
    pub(super) fn of_nobody() -> Self {
        Self { commands: channel().0, waker: None }
    }

    /// Sends a command; returns whether the thread still receives commands.
    pub(super) fn send(&self, command: Command) -> bool {
        let is_sent = self.commands.send(command).is_ok();
        if let Some(waker) = &self.waker {
            waker.wake();
        }
        is_sent
    }
}
