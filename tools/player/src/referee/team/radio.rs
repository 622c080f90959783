//! Network of a robot in simulated time: what is sent arrives in the next cycle.

use std::collections::VecDeque;

use bica_motion::robot::Sensors;
use bica_player::referee::{Identity, Received, TeamCommand, TeamSensors};
use bica_player::team::{Heard, TeamInbox, TeamMessage};

use super::player::Network;

/// Packets and messages of one robot.
pub(super) struct Radio {
    me: Identity,
    inbox: TeamInbox,
    packet: Option<Received>,
    heard: VecDeque<Heard>,
    sent: Option<TeamMessage>,
}

impl Radio {
    /// Creates the network of a player.
    pub(super) fn new(me: Identity) -> Self {
        Self { me, inbox: TeamInbox::new(me), packet: None, heard: VecDeque::new(), sent: None }
    }

    /// Passes a control packet to the robot.
    pub(super) const fn show(&mut self, packet: Received) {
        self.packet = Some(packet);
    }

    /// Passes a message of any player to the robot, at a time in µs.
    pub(super) fn hear(&mut self, message: &TeamMessage, at_us: u64) {
        let message = self.inbox.take(&message.encode(), at_us);
        self.heard.extend(message.map(|message| Heard { message, at_us }));
    }

    /// Takes the message that the robot has sent in this cycle.
    pub(super) const fn take(&mut self) -> Option<TeamMessage> {
        self.sent.take()
    }
}

impl Network for Radio {
    fn sensors<'a>(&mut self, _now: u64, body: Sensors<'a>) -> TeamSensors<'a> {
        let (packet, heard) = (self.packet.take(), self.heard.pop_front());
        TeamSensors { body, me: self.me, packet, ignored: 0, heard, refused: self.inbox.refused().total() }
    }

    fn send(&mut self, command: &TeamCommand) {
        self.sent = command.message;
    }
}
