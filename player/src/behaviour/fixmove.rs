//! A fixed movement after an alignment.

use bica::prelude::*;
use bica_motion::kick::Kick;
use bica_motion::pose::{rotate, wrap};
use bica_motion::walk::Velocity;
use libm::fabsf;

use crate::input::Measured;
use crate::motion::{Body, Kicker};
use crate::perception::{BallDetector, Odometry};
use crate::strategy::Strike;

/// How near the ball must come to the place where the kick hits it, m, ahead and sideways.
const NEAR: (f32, f32) = (0.015, 0.015);
/// How near the heading must come to the wanted one, rad.
const HEADED: f32 = 0.08;
/// How hard to correct places, 1/s, and headings, 1/s.
const GAIN: (f32, f32) = (1.5, 1.2);
/// Fastest correction, m/s and rad/s.
const FASTEST: (f32, f32) = (0.08, 0.5);

/// A ball farther away than this is walked to first, m.
const FAR: f32 = 0.5;
/// Runs in place and still before the kick: time for some images of the ball at rest.
const SETTLED: u8 = 8;

/// Lines the body up with the ball, sideways, ahead and in heading, then plays one of the six kicks.
#[derive(Debug)]
pub struct Fixmove {
    strike: Option<Strike>,
    settled: u8,
    far: bool,
    gave_up: bool,
    done: bool,
}

#[component(hz = 30, budget_us = 10)]
impl Fixmove {
    /// Has nothing to play.
    #[must_use]
    pub const fn new() -> Self {
        Self { strike: None, settled: 0, far: false, gave_up: false, done: false }
    }

    #[stop]
    fn end(&mut self) {
        *self = Self::new();
    }

    /// Steps to where the kick hits the ball.
    #[state(initial)]
    fn align(&mut self, measured: &Measured, ball: &BallDetector, odometry: &Odometry, body: &mut Body) {
        let (Some(strike), Some(at)) = (self.strike, ball.at()) else { return body.stand() };
        self.far = at.length() > FAR;
        let turn = wrap(strike.heading - odometry.pose().heading);
        let off = at - rotate(strike.kick.ball(&measured.profile().kicks), turn);
        let aligned = fabsf(off.x) < NEAR.0 && fabsf(off.y) < NEAR.1 && fabsf(turn) < HEADED;
        self.settled = if aligned && body.is_still() { self.settled.saturating_add(1) } else { 0 };
        if aligned {
            body.stand();
        } else {
            body.step_to(Velocity {
                forward: (GAIN.0 * off.x).clamp(-FASTEST.0, FASTEST.0),
                left: (GAIN.0 * off.y).clamp(-FASTEST.0, FASTEST.0),
                turn: (GAIN.1 * turn).clamp(-FASTEST.1, FASTEST.1),
            });
        }
    }

    /// Plays the kick.
    #[state]
    fn strike(&mut self, kicker: &mut Kicker) {
        if let Some(strike) = self.strike {
            kicker.play(strike.kick);
        }
    }

    /// Steps back, to come to the ball another way.
    #[state]
    fn retreat(&mut self, body: &mut Body) {
        self.gave_up = true;
        body.step_to(Velocity { forward: -FASTEST.0, left: 0.0, turn: 0.0 });
    }

    /// The kick is over.
    #[state(last)]
    fn over(&mut self, body: &mut Body) {
        self.done = true;
        body.stand();
    }

    #[transition(align -> strike)]
    fn in_place(&self) -> bool {
        self.settled >= SETTLED
    }

    /// Something is in the way, as a robot or a goal post.
    #[transition(align -> retreat, after_ms = 6000)]
    fn blocked(&self) -> bool {
        true
    }

    #[transition(retreat -> over, after_ms = 2000)]
    fn retreated(&self) -> bool {
        true
    }

    #[transition(strike -> over)]
    fn played(&self, kicker: &Kicker) -> bool {
        kicker.done()
    }

    /// Asks for `strike`; takes effect while it is not played yet.
    pub const fn play(&mut self, strike: Strike) {
        self.strike = Some(strike);
    }

    /// Whether the ball lies too far off to line up with it.
    #[must_use]
    pub const fn out_of_reach(&self) -> bool {
        self.far
    }

    /// The kick that was given up, as something was in the way.
    #[must_use]
    pub fn gave_up(&self) -> Option<Kick> {
        self.strike.filter(|_| self.gave_up).map(|strike| strike.kick)
    }

    /// Whether the kick was played to its end, or given up.
    #[must_use]
    pub const fn done(&self) -> bool {
        self.done
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::kick::KickKind;
    use bica_motion::side::Side;

    use super::*;

    const STRIKE: Strike = Strike { kick: Kick { kind: KickKind::Diagonal, foot: Side::Left }, heading: 0.0 };

    #[test]
    fn who_steps_back_tells_which_kick_was_given_up() {
        let mut fixmove = Fixmove::new();
        fixmove.play(STRIKE);
        assert_eq!(fixmove.gave_up(), None);
        fixmove.retreat(&mut Body::new());
        assert_eq!(fixmove.gave_up(), Some(STRIKE.kick));
        fixmove.end();
        assert_eq!(fixmove.gave_up(), None, "the next kick has nothing to do with it");
    }

    #[test]
    fn a_ball_that_nobody_sees_is_not_lined_up_with() {
        let mut fixmove = Fixmove::new();
        fixmove.play(STRIKE);
        fixmove.settled = SETTLED - 1;
        fixmove.align(&Measured::new(), &BallDetector::new(), &Odometry::new(), &mut Body::new());
        assert!(!fixmove.in_place() && !fixmove.out_of_reach());
    }
}
