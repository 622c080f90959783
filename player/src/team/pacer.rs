//! When a player may send, by what is left of the budget of its team.

use libm::fminf;

use super::message::TeamMessage;
use crate::referee::packet::{Control, GamePhase, PlayState};

/// Messages of each player that are never sent: those on their way when a packet is written, and those of robots that send at once.
const RESERVE: u32 = 3;
/// Time between two messages of a player that have something new, s.
const LEAST_INTERVAL: f32 = 0.1;
/// Time between two messages without something new, s, if the budget is large.
const USUAL_INTERVAL: f32 = 0.5;
/// Time between two messages without something new, s, from which on messages are too rare to agree on a striker.
const SCARCE_INTERVAL: f32 = 15.0;
/// Share of the budget for messages without something new.
const USUAL_SHARE: f32 = 0.5;
/// Number of messages that a player has saved at the start, if its share is as large.
const FIRST_CREDIT: f32 = 2.0;
/// Number of saved messages that a player keeps for changes of its part.
const KEPT: f32 = 4.0;
/// Largest number of messages that a player saves for later.
const MOST_CREDIT: f32 = 20.0;
/// Duration of a half, s.
const HALF: f32 = 600.0;
/// Time of the states ready and of a half's overtime for which the budget must last, s.
const EXTRA: f32 = 120.0;

/// Spends the budget of a team at a rate at which it lasts until the end of the game.
///
/// Each player saves the messages of its share that it does not send, and spends them when it has something new. All players count
/// each of their messages since the last packet as one of every player.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pacer {
    /// Number of the last packet.
    packet: Option<u8>,
    /// Own messages since that packet.
    since_packet: u32,
    /// Saved messages.
    credit: f32,
    /// Time since the last message, s.
    waited: f32,
    /// Messages a second that the budget allows.
    rate: f32,
    /// Whether the budget allows a message.
    has_message: bool,
    /// Whether messages have been too rare to agree on a striker since they began to count.
    is_scarce: bool,
}

impl Pacer {
    /// Creates the pacer without a budget.
    #[must_use]
    pub(super) const fn new() -> Self {
        Self {
            packet: None,
            since_packet: 0,
            credit: FIRST_CREDIT,
            waited: LEAST_INTERVAL,
            rate: 0.0,
            has_message: false,
            is_scarce: false,
        }
    }

    /// Takes what the `GameController` shows, `seconds` after the last call; `players` is the number of players of the team that send.
    pub(super) fn advance(&mut self, seconds: f32, control: Option<&Control>, budget: u32, players: u32) {
        self.waited = fminf(self.waited + seconds, TeamMessage::LONG);
        let Some(control) = control.filter(|control| counts(control)) else {
            (self.has_message, self.is_scarce, self.rate) = (false, false, 0.0);
            return;
        };
        if self.packet != Some(control.number) {
            (self.packet, self.since_packet) = (Some(control.number), 0);
        }
        let players = players.max(1);
        let left = budget.saturating_sub(RESERVE * players).saturating_sub(self.since_packet * players);
        let share = left as f32 / players as f32;
        self.rate = fminf(share / time_left(control), 1.0 / LEAST_INTERVAL);
        let saved = self.credit + self.rate * seconds;
        self.credit = fminf(saved, fminf(MOST_CREDIT, share));
        // A message more must leave the reserve of all.
        self.has_message = left >= players && self.credit >= 1.0;
        self.is_scarce |= self.interval() > SCARCE_INTERVAL;
    }

    /// Whether messages are too rare to agree on a striker. This does not end before the half does: players that change at different
    /// times would disagree.
    #[must_use]
    pub(super) const fn is_scarce(&self) -> bool {
        self.is_scarce
    }

    /// Whether a claim can be repeated until the others have probably heard it.
    #[must_use]
    pub(super) fn can_claim(&self) -> bool {
        self.has_message && self.credit >= KEPT
    }

    /// Whether a message about a change of the own part may be sent now.
    #[must_use]
    pub(super) fn may_send(&self) -> bool {
        self.has_message && self.waited >= LEAST_INTERVAL
    }

    /// Whether another message may be sent now: the last ones that are saved are for claims.
    #[must_use]
    pub(super) fn may_spare(&self) -> bool {
        self.may_send() && (self.is_scarce || self.credit >= KEPT)
    }

    /// Whether a message without something new is due, and may be sent.
    #[must_use]
    pub(super) fn is_due(&self) -> bool {
        self.may_spare() && self.waited >= self.interval()
    }

    /// Longest time between two messages, s.
    #[must_use]
    pub(super) fn interval(&self) -> f32 {
        let slow = 1.0 / (USUAL_SHARE * self.rate);
        slow.clamp(USUAL_INTERVAL, TeamMessage::LONG)
    }

    /// Counts a message that is sent.
    pub(super) const fn count(&mut self) {
        self.since_packet = self.since_packet.saturating_add(1);
        (self.credit, self.waited, self.has_message) = (self.credit - 1.0, 0.0, false);
    }
}

/// Whether messages are allowed, and counted, in the state that is shown.
fn counts(control: &Control) -> bool {
    let is_game = matches!(control.game_phase, GamePhase::Normal | GamePhase::ExtraTime);
    is_game && matches!(control.state, PlayState::Ready | PlayState::Set | PlayState::Playing)
}

/// Time for which the budget must last, s.
fn time_left(control: &Control) -> f32 {
    let other_half = if control.first_half { HALF } else { 0.0 };
    f32::from(control.seconds_remaining.max(0)) + other_half + EXTRA
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;

    const CYCLE: f32 = 0.01;

    /// Three players that send whenever they may, with packets at 2 Hz that are a second old; returns messages that are left and
    /// the times of the first player's messages, s.
    fn play(budget: u32, seconds: u16, is_eager: bool) -> (i64, std::vec::Vec<f32>) {
        let mut players = [Pacer::new(); 3];
        let (mut left, mut shown, mut times) = (i64::from(budget), [budget; 3], std::vec::Vec::new());
        for cycle in 0..u32::from(seconds) * 100 {
            let time = cycle as f32 * CYCLE;
            if cycle % 50 == 0 {
                shown = [shown[1], shown[2], u32::try_from(left).expect("not below 0")];
            }
            let control = Control {
                number: (cycle / 50) as u8,
                state: PlayState::Playing,
                seconds_remaining: seconds as i16 - time as i16,
                ..Control::default()
            };
            for (index, player) in players.iter_mut().enumerate() {
                player.advance(CYCLE, Some(&control), shown[0], 3);
                if player.is_due() || is_eager && player.may_send() {
                    player.count();
                    left -= 1;
                    assert!(left >= 0, "{time} s");
                    if index == 0 {
                        times.push(time);
                    }
                }
            }
        }
        (left, times)
    }

    #[test]
    fn eager_players_never_exceed_the_budget() {
        for budget in (0..40).chain([100, 300, 1200, 12_000]) {
            play(budget, 240, true);
        }
        assert_eq!(play(9, 240, true).0, 9, "the reserve is not sent");
    }

    #[test]
    fn budget_holds_after_the_last_packet() {
        let control = Control { state: PlayState::Playing, ..Control::default() };
        let mut pacer = Pacer::new();
        let sent = (0..600_000).filter(|_| {
            pacer.advance(CYCLE, Some(&control), 100, 3);
            let may = pacer.may_send();
            (0..u32::from(may)).for_each(|_| pacer.count());
            may
        });
        let sent = sent.count();
        assert!((20..=30).contains(&sent), "{sent} of a third of 91");
    }

    #[test]
    fn budget_lasts_until_the_end() {
        let (left, times) = play(300, 600, true);
        assert!(left < 80, "{left}");
        assert!(times.last().is_some_and(|last| *last > 560.0), "{times:?}");
        let gap = times.windows(2).fold(0.0_f32, |gap, pair| gap.max(pair[1] - pair[0]));
        assert!(gap < 20.0, "{gap} s");
    }

    #[test]
    fn large_budget_gives_two_messages_a_second() {
        let (_, times) = play(12_000, 600, false);
        let after = times.iter().filter(|time| **time > 60.0);
        let rate = after.count() as f32 / 540.0;
        assert!((1.8..=2.0).contains(&rate), "{rate} a second");
    }

    #[test]
    fn messages_are_kept_for_claims() {
        let control = Control { state: PlayState::Playing, seconds_remaining: 600, ..Control::default() };
        let may = |budget, seconds| {
            let mut pacer = Pacer::new();
            (0..seconds).for_each(|_| pacer.advance(1.0, Some(&control), budget, 3));
            (pacer.may_send(), pacer.may_spare(), pacer.can_claim(), pacer.is_scarce())
        };
        assert_eq!(may(1200, 1), (true, false, false, false));
        assert_eq!(may(1200, 10), (true, true, true, false));
        assert_eq!(may(100, 1), (true, true, false, true), "claims are of no use");
    }

    #[test]
    fn nothing_is_sent_where_messages_do_not_count() {
        let may = |control: Option<Control>| {
            let mut pacer = Pacer::new();
            (0..1000).for_each(|_| pacer.advance(CYCLE, control.as_ref(), 12_000, 3));
            pacer.may_send()
        };
        let control = |state| Some(Control { state, ..Control::default() });
        assert!([PlayState::Ready, PlayState::Set, PlayState::Playing].into_iter().all(|state| may(control(state))));
        assert!(!may(None) && !may(control(PlayState::Initial)) && !may(control(PlayState::Finished)));
        for game_phase in [GamePhase::Shootout, GamePhase::TimeOut] {
            let control = Control { state: PlayState::Playing, game_phase, ..Control::default() };
            assert!(!may(Some(control)));
        }
    }
}
