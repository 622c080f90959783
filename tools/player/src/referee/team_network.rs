//! Socket for the messages of a team.

use std::collections::VecDeque;
use std::net::{SocketAddrV4, UdpSocket};

use bica_app::Failure;
use bica_player::referee::Identity;
use bica_player::team::{Heard, TeamInbox, TeamMessage};

use super::network::{self, Ports, WAITING};

/// Exchanges messages with the other players of a team: all of them listen on one port and send to the broadcast address.
pub(super) struct TeamNetwork {
    socket: UdpSocket,
    inbox: TeamInbox,
    to: SocketAddrV4,
    waiting: VecDeque<Heard>,
    sent: u64,
}

impl TeamNetwork {
    /// Opens the socket of a player.
    ///
    /// # Errors
    /// If the port cannot be opened.
    pub(super) fn open(me: Identity, ports: &Ports) -> Result<Self, Failure> {
        let socket = network::open(ports.team)?;
        let to = SocketAddrV4::new(ports.broadcast, ports.team);
        Ok(Self { socket, inbox: TeamInbox::new(me), to, waiting: VecDeque::new(), sent: 0 })
    }

    /// Reads all datagrams that have arrived until `now`, µs, and returns the oldest waiting message.
    pub(super) fn receive(&mut self, now: u64) -> Option<Heard> {
        let Self { socket, inbox, waiting, .. } = self;
        network::drain(socket, |datagram, _| {
            if let Some(message) = inbox.take(datagram, now) {
                waiting.push_back(Heard { message, at_us: now });
            }
            if waiting.len() > WAITING {
                waiting.pop_front();
            }
        });
        waiting.pop_front()
    }

    /// Sends a message; a lost message is not sent again.
    pub(super) fn send(&mut self, message: &TeamMessage) {
        if self.socket.send_to(&message.encode(), self.to).is_ok() {
            self.sent += 1;
        }
    }

    /// Number of messages that were sent.
    pub(super) const fn sent(&self) -> u64 {
        self.sent
    }

    /// Number of datagrams that were no new messages of other players of the team; the own messages come back, too.
    pub(super) fn refused(&self) -> u32 {
        self.inbox.refused().total()
    }
}
