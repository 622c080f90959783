//! A fixed movement after an alignment.

use bica::prelude::*;
use bica::visual::Pose2;
use bica_motion::kick::Kick;
use bica_motion::pose::{rotate, wrap};
use bica_motion::walk::Velocity;

use super::LineUp;
use crate::input::RobotProfile;
use crate::motion::{KickChoice, Kicker, SideChoice};
use crate::roles::{Ball, Legs, Odometer};
use crate::strategy::Strike;

/// Lines the body up with the ball, sideways, forward and in heading, then plays one of the six kicks.
#[derive(Debug)]
pub struct Fixmove {
    strike: Option<Strike>,
    /// Kick that an operator requested, and the turn before it, rad.
    by_hand: Option<(Kick, f32)>,
    /// Way to the pose in which the kick hits the ball, in the ground frame; `None` without a kick or a ball.
    error: Option<Pose2>,
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
        Self { strike: None, by_hand: None, error: None, settled: 0, far: false, failed: false, done: false }
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    #[entry(align)]
    fn begin(&mut self) {
        *self = Self { strike: self.strike, by_hand: self.by_hand, ..Self::new() };
    }

    /// Steps to the pose in which the kick hits the ball.
    #[state(initial)]
    fn align(
        &mut self,
        tuned: &Tuned<LineUp>,
        profile: &RobotProfile,
        ball: &impl Ball,
        odometry: &impl Odometer,
        body: &mut impl Legs,
    ) {
        if let Some((kick, turn)) = self.by_hand.take() {
            self.strike = Some(Strike { kick, heading: odometry.pose().heading + turn });
        }
        let (Some(strike), Some(at)) = (self.strike, ball.position()) else {
            self.error = None;
            return body.stand();
        };
        self.far = at.length() > tuned.far_distance;
        let turn = wrap(strike.heading - odometry.pose().heading);
        let error = at - rotate(tuned.ball(strike.kick, &profile.get().kicks), turn);
        let error = Pose2 { x: error.x, y: error.y, heading: turn };
        self.error = Some(error);
        let aligned = tuned.allows(&error);
        self.settled = if aligned && body.is_still() { self.settled.saturating_add(1) } else { 0 };
        if aligned {
            body.stand();
        } else {
            body.step_with(tuned.velocity(&error));
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
    fn retreat(&mut self, tuned: &Tuned<LineUp>, body: &mut impl Legs) {
        self.failed = true;
        body.step_with(Velocity { forward: -tuned.retreat_speed, left: 0.0, turn: 0.0 });
    }

    /// State after the kick.
    #[state]
    fn over(&mut self, body: &mut impl Legs) {
        self.done = true;
        body.stand();
    }

    #[transition(align -> strike)]
    fn in_place(&self, tuned: &Tuned<LineUp>) -> bool {
        u32::from(self.settled) >= tuned.settled_runs
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

    /// Only an operator requests a kick after another one; an activator makes the component latent first.
    #[transition(over -> align)]
    fn requested_by_hand(&self) -> bool {
        self.by_hand.is_some()
    }

    /// Requests a kick; has no effect on a kick in progress.
    pub const fn play(&mut self, strike: Strike) {
        self.strike = Some(strike);
    }

    /// Lines up for a kick and plays it. During a kick the request is for the next one.
    #[modulation]
    pub fn kick(
        &mut self,
        /// Direction of the ball.
        direction: KickChoice,
        /// Kicking foot.
        foot: SideChoice,
        /// Turn of the body before the kick, positive to the left.
        #[range(-3.1..=3.1)]
        #[unit("rad")]
        #[step(0.1)]
        turn: f32,
    ) {
        self.by_hand = Some((direction.with(foot), turn));
    }

    /// The requested kick, with its heading in the frame of the odometry.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn requested(&self) -> Option<Strike> {
        self.strike
    }

    /// Way from the body to the pose in which the kick hits the ball, forward and left, with the turn; `None` without a
    /// requested kick or a ball.
    #[output(unit = "m, rad", frame = "robot")]
    #[must_use]
    pub const fn error(&self) -> Option<Pose2> {
        self.error
    }

    /// Number of aligned runs at rest.
    #[output]
    #[must_use]
    pub const fn settled(&self) -> u8 {
        self.settled
    }

    /// Whether the ball is too far away to line up.
    #[output]
    #[must_use]
    pub const fn out_of_reach(&self) -> bool {
        self.far
    }

    /// The kick that was given up because the robot could not line up.
    #[output]
    #[must_use]
    pub fn failed_kick(&self) -> Option<Kick> {
        self.strike.filter(|_| self.failed).map(|strike| strike.kick)
    }

    /// Whether the kick was played to its end or given up.
    #[output]
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
    use crate::motion::Body;
    use crate::motion::Request;
    use crate::perception::BallDetector;
    use crate::perception::Odometry;

    const STRIKE: Strike = Strike { kick: Kick { kind: KickKind::Diagonal, foot: Side::Left }, heading: 0.0 };

    fn align(fixmove: &mut Fixmove) {
        let (ball, odometry) = (BallDetector::new(), Odometry::new());
        fixmove.align(&Tuned::DEFAULT, &RobotProfile::new(), &ball, &odometry, &mut Body::new());
    }

    #[test]
    fn retreat_reports_the_failed_kick() {
        let mut fixmove = Fixmove::new();
        fixmove.play(STRIKE);
        assert_eq!(fixmove.failed_kick(), None);
        fixmove.retreat(&Tuned::DEFAULT, &mut Body::new());
        assert_eq!(fixmove.failed_kick(), Some(STRIKE.kick));
        fixmove.reset();
        assert_eq!(fixmove.failed_kick(), None);
    }

    #[test]
    fn a_retreat_has_the_tuned_speed() {
        let (mut body, tuned) = (Body::new(), Tuned::new(LineUp { retreat_speed: 0.05, ..LineUp::DEFAULT }));
        Fixmove::new().retreat(&tuned, &mut body);
        assert_eq!(body.request(), Request::Step(Velocity { forward: -0.05, left: 0.0, turn: 0.0 }));
    }

    #[test]
    fn unknown_ball_position_allows_no_kick() {
        let mut fixmove = Fixmove::new();
        fixmove.play(STRIKE);
        fixmove.settled = LineUp::DEFAULT.settled_runs as u8 - 1;
        align(&mut fixmove);
        assert!(!fixmove.in_place(&Tuned::DEFAULT) && !fixmove.out_of_reach());
        assert_eq!(fixmove.error(), None);
    }

    #[test]
    fn kick_begins_after_tuned_number_of_runs() {
        let fixmove = Fixmove { settled: 4, ..Fixmove::new() };
        for (settled_runs, begins) in [(4, true), (5, false)] {
            assert_eq!(fixmove.in_place(&Tuned::new(LineUp { settled_runs, ..LineUp::DEFAULT })), begins);
        }
    }

    #[test]
    fn requested_kick_starts_anew_after_another() {
        let mut fixmove = Fixmove::new();
        fixmove.play(STRIKE);
        fixmove.over(&mut Body::new());
        assert!(fixmove.done() && !fixmove.requested_by_hand());
        fixmove.kick(KickChoice::Front, SideChoice::Right, 0.5);
        assert!(fixmove.requested_by_hand());
        fixmove.begin();
        align(&mut fixmove);
        let expected = Strike { kick: Kick { kind: KickKind::Front, foot: Side::Right }, heading: 0.5 };
        assert_eq!((fixmove.requested(), fixmove.done()), (Some(expected), false));
        assert!(!fixmove.requested_by_hand(), "once");
    }
}
