//! Datagrams that a player receives on the port of its team.

use super::message::TeamMessage;
use super::refusal::{Refusal, Refused};
use crate::referee::Identity;
use crate::referee::packet::PLAYERS;

/// Silence of a sender after which its clock may have begun anew, because its program was started again, µs.
const RESTART_US: u64 = 4_000_000;

/// Finds the messages of the own team among all datagrams, and counts the others.
#[derive(Clone, Copy, Debug)]
pub struct TeamInbox {
    me: Identity,
    /// Of each player, the sender's time of the newest message, ms, and its arrival, µs.
    newest: [Option<(u32, u64)>; PLAYERS],
    refused: Refused,
}

impl TeamInbox {
    /// Creates the inbox of a player.
    #[must_use]
    pub fn new(me: Identity) -> Self {
        Self { me, newest: [None; PLAYERS], refused: Refused::default() }
    }

    /// Reads a datagram that has arrived at a time, µs; `None` if it is no new message of another player of the team.
    pub fn take(&mut self, datagram: &[u8], at_us: u64) -> Option<TeamMessage> {
        match self.read(datagram, at_us) {
            Ok(message) => Some(message),
            Err(why) => {
                self.refused.count(why);
                None
            }
        }
    }

    fn read(&mut self, datagram: &[u8], at_us: u64) -> Result<TeamMessage, Refusal> {
        let message = TeamMessage::decode(datagram)?;
        let Identity { team, player } = message.from;
        match () {
            () if team != self.me.team => return Err(Refusal::ForeignTeam(team)),
            () if player == self.me.player => return Err(Refusal::OwnNumber),
            () => {}
        }
        let newest = self.newest.get_mut(usize::from(player).wrapping_sub(1)).ok_or(Refusal::Player(player))?;
        let is_past = newest.is_some_and(|(time_ms, arrived_us)| {
            message.time_ms <= time_ms && at_us.saturating_sub(arrived_us) < RESTART_US
        });
        if is_past {
            return Err(Refusal::Past);
        }
        *newest = Some((message.time_ms, at_us));
        Ok(message)
    }

    /// Numbers of the datagrams that were refused. The own messages, which a broadcast brings back, count as those of the own number.
    #[must_use]
    pub const fn refused(&self) -> &Refused {
        &self.refused
    }
}
