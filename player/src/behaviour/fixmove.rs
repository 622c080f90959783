//! A fixed movement after an alignment.

use bica::prelude::*;
use bica_motion::kick::Kick;
use bica_motion::pose::{rotate, wrap};
use bica_motion::walk::Velocity;
use libm::fabsf;

use crate::input::RobotProfile;
use crate::motion::{Body, Kicker};
use crate::perception::{BallDetector, Odometry};
use crate::strategy::Strike;

/// Largest position error of the ball before a kick, forward and sideways each, m.
const POSITION_TOLERANCE: f32 = 0.015;
/// Largest heading error before a kick, rad.
const HEADING_TOLERANCE: f32 = 0.08;
/// Position gain, 1/s.
const POSITION_GAIN: f32 = 1.5;
/// Heading gain, 1/s.
const HEADING_GAIN: f32 = 1.2;
/// Largest correction speed, forward and sideways each, m/s.
const MAX_SPEED: f32 = 0.08;
/// Largest turning speed, rad/s.
const MAX_TURN: f32 = 0.5;
/// Distance of the ball beyond which it has to be approached again, m.
const FAR: f32 = 0.5;
/// Number of aligned runs at rest before the kick: time for some images of the ball.
const SETTLED: u8 = 8;

/// Lines the body up with the ball, sideways, forward and in heading, then plays one of the six kicks.
#[derive(Debug)]
pub struct Fixmove {
    strike: Option<Strike>,
    /// Number of aligned runs at rest.
    settled: u8,
    far: bool,
    failed: bool,
    done: bool,
}

#[component(hz = 30, budget_us = 10)]
impl Fixmove {
    /// Creates the component without a requested kick.
    #[must_use]
    pub const fn new() -> Self {
        Self { strike: None, settled: 0, far: false, failed: false, done: false }
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    /// Steps to the pose in which the kick hits the ball.
    #[state(initial)]
    fn align(&mut self, profile: &RobotProfile, ball: &BallDetector, odometry: &Odometry, body: &mut Body) {
        let (Some(strike), Some(at)) = (self.strike, ball.position()) else { return body.stand() };
        self.far = at.length() > FAR;
        let turn = wrap(strike.heading - odometry.pose().heading);
        let error = at - rotate(strike.kick.ball(&profile.get().kicks), turn);
        let aligned = fabsf(error.x) < POSITION_TOLERANCE
            && fabsf(error.y) < POSITION_TOLERANCE
            && fabsf(turn) < HEADING_TOLERANCE;
        self.settled = if aligned && body.is_still() { self.settled.saturating_add(1) } else { 0 };
        if aligned {
            body.stand();
        } else {
            body.step_with(Velocity {
                forward: (POSITION_GAIN * error.x).clamp(-MAX_SPEED, MAX_SPEED),
                left: (POSITION_GAIN * error.y).clamp(-MAX_SPEED, MAX_SPEED),
                turn: (HEADING_GAIN * turn).clamp(-MAX_TURN, MAX_TURN),
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

    /// Steps back for another attempt from another position.
    #[state]
    fn retreat(&mut self, body: &mut Body) {
        self.failed = true;
        body.step_with(Velocity { forward: -MAX_SPEED, left: 0.0, turn: 0.0 });
    }

    /// State after the kick.
    #[state(last)]
    fn over(&mut self, body: &mut Body) {
        self.done = true;
        body.stand();
    }

    #[transition(align -> strike)]
    fn in_place(&self) -> bool {
        self.settled >= SETTLED
    }

    /// Whether an obstacle, such as another robot or a goal post, prevents the alignment.
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

    /// Requests a kick; has no effect on one that is being played.
    pub const fn play(&mut self, strike: Strike) {
        self.strike = Some(strike);
    }

    /// Whether the ball is too far away to line up.
    #[must_use]
    pub const fn out_of_reach(&self) -> bool {
        self.far
    }

    /// The kick that was given up because the robot could not line up.
    #[must_use]
    pub fn failed_kick(&self) -> Option<Kick> {
        self.strike.filter(|_| self.failed).map(|strike| strike.kick)
    }

    /// Whether the kick was played to its end or given up.
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
    fn a_retreat_reports_the_failed_kick_until_the_component_stops() {
        let mut fixmove = Fixmove::new();
        fixmove.play(STRIKE);
        assert_eq!(fixmove.failed_kick(), None);
        fixmove.retreat(&mut Body::new());
        assert_eq!(fixmove.failed_kick(), Some(STRIKE.kick));
        fixmove.reset();
        assert_eq!(fixmove.failed_kick(), None);
    }

    #[test]
    fn an_unknown_ball_position_allows_no_kick() {
        let mut fixmove = Fixmove::new();
        fixmove.play(STRIKE);
        fixmove.settled = SETTLED - 1;
        fixmove.align(&RobotProfile::new(), &BallDetector::new(), &Odometry::new(), &mut Body::new());
        assert!(!fixmove.in_place() && !fixmove.out_of_reach());
    }
}
