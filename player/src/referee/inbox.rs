//! Datagrams that a player receives on the port of the control packets.

use super::packet::{Control, Ignored, Mismatch};

/// Finds the control packets for a team among all datagrams, and counts the others.
#[derive(Clone, Copy, Debug)]
pub struct Inbox {
    team: u8,
    ignored: Ignored,
}

impl Inbox {
    /// Creates an inbox of the team with a number.
    #[must_use]
    pub fn new(team: u8) -> Self {
        Self { team, ignored: Ignored::default() }
    }

    /// Reads a datagram; `None` if it is no control packet for this team.
    pub fn take(&mut self, datagram: &[u8]) -> Option<Control> {
        let packet = Control::parse(datagram).and_then(|control| match control.index(self.team) {
            Some(_) => Ok(control),
            None => Err(Mismatch::ForeignTeams(control.teams.map(|team| team.number))),
        });
        packet.map_err(|why| self.ignored.count(why)).ok()
    }

    /// Numbers of the datagrams that were ignored.
    #[must_use]
    pub const fn ignored(&self) -> &Ignored {
        &self.ignored
    }
}

#[cfg(test)]
mod tests {
    use super::super::packet::{CONTROL_BYTES, Team, Version};
    use super::*;

    #[test]
    fn only_packets_for_the_own_team_are_taken() {
        let mut out = [0; CONTROL_BYTES];
        let mut inbox = Inbox::new(5);
        let control = |teams: [u8; 2]| Control {
            version: Version::V19,
            teams: teams.map(|number| Team { number, ..Team::default() }),
            ..Control::default()
        };
        for teams in [[5, 23], [23, 5]] {
            let sent = control(teams);
            assert_eq!(inbox.take(sent.encode(&mut out).expect("no penalty")), Some(sent));
        }
        assert_eq!(inbox.ignored().total(), 0);
        assert_eq!(inbox.take(control([6, 23]).encode(&mut out).expect("no penalty")), None);
        assert_eq!(inbox.ignored().of(Mismatch::ForeignTeams([6, 23])), 1);
        for noise in [&b"RGme"[..], b"RGTD-the-true-state", b"RGrt\x04", b"RGme\x12", &out[..197], b""] {
            assert_eq!(inbox.take(noise), None);
        }
        assert_eq!(inbox.ignored().total(), 7);
        let kinds = [Mismatch::Short(0), Mismatch::TrueState, Mismatch::Header([0; 4]), Mismatch::Version(0)];
        assert_eq!(kinds.map(|kind| inbox.ignored().of(kind)), [2, 1, 1, 1]);
        assert_eq!(inbox.ignored().of(Mismatch::Length(Version::V19, 0)), 1);
    }
}
