//! A `GameController` with a bad network.

use bica_player::referee::packet::{CONTROL_BYTES, Control, PlayState, Team};
use bica_player::referee::{Inbox, Received};

/// Address of the `GameController`.
pub(super) const SOURCE: [u8; 4] = [127, 0, 0, 1];
/// Cycles between two packets: 2 Hz.
const PERIOD: u64 = 50;
/// Cycles between two datagrams of noise.
const NOISE: u64 = 7;

/// Sends packets through the inboxes of players, and datagrams that must be ignored between them.
pub(super) struct Sender {
    pub(super) control: Control,
    cycle: u64,
    /// Whether there are other datagrams. A player that starts between them would take the first one as its `GameController`'s.
    is_noisy: bool,
}

impl Sender {
    /// Creates a sender before its first packet.
    pub(super) const fn new(control: Control, is_noisy: bool) -> Self {
        Self { control, cycle: 0, is_noisy }
    }

    /// Begins the next cycle. The order of the teams changes with each packet.
    pub(super) fn advance(&mut self) {
        self.cycle += 1;
        if self.cycle.is_multiple_of(PERIOD) {
            self.control.number = self.control.number.wrapping_add(1);
            self.control.teams.swap(0, 1);
        }
    }

    /// A team by its number.
    pub(super) fn team(&mut self, number: u8) -> &mut Team {
        self.control.teams.iter_mut().find(|team| team.number == number).expect("it plays")
    }

    /// What a player receives in this cycle.
    pub(super) fn receive(&self, inbox: &mut Inbox) -> Option<Received> {
        if self.cycle.is_multiple_of(PERIOD) {
            let mut out = [0; CONTROL_BYTES];
            let datagram = self.control.encode(&mut out).expect("all penalties have numbers");
            return Some(self.received(inbox.take(datagram).expect("a packet for the team"), SOURCE));
        }
        (self.is_noisy && self.cycle > PERIOD && self.cycle.is_multiple_of(NOISE)).then(|| self.noise(inbox))
    }

    /// Sends truncated packets, true states, and packets for other teams with another state of the game. Returns a late packet, or
    /// one from another sender.
    fn noise(&self, inbox: &mut Inbox) -> Received {
        let mut out = [0; CONTROL_BYTES];
        let state = if self.control.state == PlayState::Playing { PlayState::Finished } else { PlayState::Playing };
        let foreign = [7, 8].map(|number| Team { number, ..Team::default() });
        let control = Control { state, ..self.control };
        assert_eq!(inbox.take(Control { teams: foreign, ..control }.encode(&mut out).expect("no penalty")), None);
        let datagram = control.encode(&mut out).expect("all penalties have numbers");
        for noise in [&datagram[1..], &datagram[..157], &[&b"RGTD"[..], &datagram[4..]].concat()] {
            assert_eq!(inbox.take(noise), None);
        }
        if self.cycle.is_multiple_of(2) {
            self.received(Control { number: control.number.wrapping_sub(3), ..control }, SOURCE)
        } else {
            self.received(control, [9; 4])
        }
    }

    const fn received(&self, control: Control, source: [u8; 4]) -> Received {
        Received { control, source, at_us: 10_000 * self.cycle }
    }
}
