//! Who plays the ball: each player decides for itself, by what it has heard of the others.
//!
//! A player becomes the striker by a *claim* with a number above all that it knows. A striker yields to one with a newer claim, or with
//! the same number and a lower number of the player. So of several strikers one stays in any case, whatever messages are lost: the one
//! with the newest claim has nobody to yield to. Times to the ball, which each player knows at another instant, only decide when a
//! player claims.

use bica::prelude::*;

/// When a player claims to be the striker.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Claiming {
    /// Lead in the time to the ball with which a player takes over from the striker.
    #[param(default = 2.0, range = 0.0..=20.0, unit = "s", step = 0.5)]
    pub lead: f32,
    /// Time for which the lead must last.
    #[param(default = 0.5, range = 0.0..=5.0, unit = "s", step = 0.1)]
    pub patience: f32,
    /// Time without a striker after which the nearest player claims.
    #[param(default = 0.3, range = 0.0..=2.0, unit = "s", step = 0.1)]
    pub vacancy: f32,
    /// Further time for each player that is nearer: it may have claimed, and its message was lost.
    #[param(default = 0.4, range = 0.0..=2.0, unit = "s", step = 0.1)]
    pub precedence: f32,
    /// With few messages: time in which the ball does not move after which the next player takes it, as if there were no striker.
    #[param(default = 90.0, range = 5.0..=600.0, unit = "s", step = 5.0)]
    pub rest: f32,
}

/// What a player knows of one that may be the striker, itself included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Candidate {
    /// Number of the player.
    pub(super) player: u8,
    /// Time to the ball, s; `None` if it does not know the ball.
    pub(super) time: Option<f32>,
    /// Whether it is the striker.
    pub(super) is_striker: bool,
    /// Number of the newest claim that it knows.
    pub(super) claim: u16,
}

impl Candidate {
    /// Whether it is nearer to the ball than another one.
    fn is_before(&self, other: &Self) -> bool {
        let time = |candidate: &Self| candidate.time.unwrap_or(f32::INFINITY);
        time(self).total_cmp(&time(other)).then(self.player.cmp(&other.player)).is_lt()
    }

    /// Whether a striker must yield to this one.
    const fn prevails_over(&self, other: &Self) -> bool {
        self.claim > other.claim || self.claim == other.claim && self.player < other.player
    }
}

/// State of one player in the election of the striker.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Election {
    is_striker: bool,
    claim: u16,
    /// Time without a striker, s.
    vacant: f32,
    /// Time for which this player has led the striker, s.
    led: f32,
}

impl Election {
    /// Creates the state before the first claim.
    #[must_use]
    pub(super) const fn new() -> Self {
        Self { is_striker: false, claim: 0, vacant: 0.0, led: 0.0 }
    }

    /// Whether this player is the striker.
    #[must_use]
    pub(super) const fn is_striker(&self) -> bool {
        self.is_striker
    }

    /// Number of the newest claim that this player knows.
    #[must_use]
    pub(super) const fn claim(&self) -> u16 {
        self.claim
    }

    /// Decides again, `seconds` after the last decision. `me` has number and time of this player, or is `None` if it cannot be the
    /// striker; it takes over from a striker only if the others hear of it. `mates` are the other players that can be the striker.
    pub(super) fn decide(
        &mut self,
        tuned: &Claiming,
        seconds: f32,
        me: Option<(u8, Option<f32>)>,
        is_heard: bool,
        mates: impl Iterator<Item = Candidate> + Clone,
    ) {
        let known = mates.clone().fold(self.claim, |known, mate| known.max(mate.claim));
        let Some((player, time)) = me else {
            *self = Self { claim: known, ..Self::new() };
            return;
        };
        let me = Candidate { player, time, is_striker: self.is_striker, claim: self.claim };
        if self.is_striker {
            self.is_striker = !mates.clone().any(|mate| mate.is_striker && mate.prevails_over(&me));
            if self.is_striker {
                return;
            }
        }
        self.claim = known;
        if self.claims(tuned, seconds, &me, is_heard, mates) {
            *self = Self { is_striker: true, claim: known.saturating_add(1), ..Self::new() };
        }
    }

    /// Sets whether this player is the striker, without a claim.
    pub(super) const fn appoint(&mut self, is_striker: bool) {
        *self = Self { is_striker, claim: self.claim, ..Self::new() };
    }

    /// Whether a player that is not the striker becomes it; at once if it hears no other one.
    fn claims(
        &mut self,
        tuned: &Claiming,
        seconds: f32,
        me: &Candidate,
        is_heard: bool,
        mates: impl Iterator<Item = Candidate> + Clone,
    ) -> bool {
        if mates.clone().next().is_none() {
            return true;
        }
        let nearer = mates.clone().filter(|mate| !mate.is_striker && mate.is_before(me)).count() as f32;
        let striker = mates
            .filter(|mate| mate.is_striker)
            .reduce(|one, other| if other.prevails_over(&one) { other } else { one });
        let Some(striker) = striker else {
            (self.vacant, self.led) = (self.vacant + seconds, 0.0);
            return self.vacant >= tuned.vacancy + nearer * tuned.precedence;
        };
        let limit = striker.time.unwrap_or(f32::INFINITY);
        let leads = nearer < 1.0 && me.time.is_some_and(|time| time + tuned.lead < limit);
        (self.vacant, self.led) = (0.0, if leads { self.led + seconds } else { 0.0 });
        leads && is_heard && self.led >= tuned.patience
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CYCLE: f32 = 0.01;

    fn mate(player: u8, time: f32, is_striker: bool, claim: u16) -> Candidate {
        Candidate { player, time: Some(time), is_striker, claim }
    }

    /// Time after which a player claims, ms; `None` if it does not within 10 s.
    fn claims_after(election: &mut Election, me: (u8, Option<f32>), mates: &[Candidate]) -> Option<u32> {
        (0..1000).find_map(|cycle| {
            election.decide(&Claiming::DEFAULT, CYCLE, Some(me), true, mates.iter().copied());
            election.is_striker().then_some(10 * cycle)
        })
    }

    #[test]
    fn nearest_player_claims_first_without_a_striker() {
        let (near, far) = (mate(2, 3.0, false, 4), mate(3, 5.0, false, 4));
        let mut election = Election::new();
        let first = claims_after(&mut election, (2, near.time), &[far]).expect("a claim");
        assert!((280..=310).contains(&first) && election.claim() == 5, "{first} ms");
        let second = claims_after(&mut Election::new(), (3, far.time), &[near]).expect("a claim");
        assert!((680..=710).contains(&second), "{second} ms");
        let unseen = claims_after(&mut Election::new(), (1, None), &[near, far]).expect("a claim");
        assert!(unseen > second, "a player that does not know the ball is the last");
    }

    #[test]
    fn player_that_hears_nobody_claims_at_once() {
        assert_eq!(claims_after(&mut Election::new(), (3, None), &[]), Some(0));
    }

    #[test]
    fn takeover_needs_a_lasting_lead() {
        let striker = mate(1, 5.0, true, 7);
        let after = |time| claims_after(&mut Election::new(), (2, Some(time)), &[striker]);
        assert_eq!(after(3.5), None);
        assert!(after(2.5).is_some_and(|after| (480..=510).contains(&after)));
        let nearer = mate(3, 2.0, false, 7);
        assert_eq!(claims_after(&mut Election::new(), (2, Some(2.5)), &[striker, nearer]), None);
        let blind = Candidate { time: None, ..striker };
        assert!(claims_after(&mut Election::new(), (2, Some(30.0)), &[blind]).is_some());
        let mut unheard = Election::new();
        for _ in 0..1000 {
            unheard.decide(&Claiming::DEFAULT, CYCLE, Some((2, Some(1.0))), false, [blind].into_iter());
        }
        assert!(!unheard.is_striker(), "the striker would not yield");
    }

    #[test]
    fn striker_yields_to_newer_claims_only() {
        let yields = |other: Candidate| {
            let mut election = Election { is_striker: true, claim: 7, ..Election::new() };
            election.decide(&Claiming::DEFAULT, CYCLE, Some((2, Some(9.0))), true, [other].into_iter());
            !election.is_striker()
        };
        assert!(yields(mate(3, 20.0, true, 8)));
        assert!(!yields(mate(3, 1.0, true, 6)) && !yields(mate(3, 1.0, false, 8)));
        assert!(yields(mate(1, 20.0, true, 7)) && !yields(mate(3, 1.0, true, 7)));
    }

    #[test]
    fn player_that_cannot_play_is_no_striker() {
        let mut election = Election { is_striker: true, claim: 7, ..Election::new() };
        election.decide(&Claiming::DEFAULT, CYCLE, None, true, [mate(3, 1.0, false, 9)].into_iter());
        assert_eq!((election.is_striker(), election.claim()), (false, 9));
    }
}
