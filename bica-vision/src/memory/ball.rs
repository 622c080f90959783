//! The remembered ball: it rests or it rolls, and both are believed as far as the sightings fit.
//!
//! Two Kalman filters, one of a resting ball (a place) and one of a rolling one (place and velocity, braked by the
//! carpet), run side by side. A resting ball may be kicked, a rolling one may stop; so at each step each filter takes
//! some of the other in (interacting multiple models, Blom and Bar-Shalom 1988). Sightings weigh them by likelihood.
//! Cost: 0.4 µs for each motion, 0.2 µs for each sighting.

use bica_motion::pose::Pose2;
use glam::Vec2;
use libm::expf;

use super::belief::Belief;
use super::position_estimate::{GATE, PositionEstimate, turned};
use super::rolling::Rolling;
use super::{LASTING, sound};
use crate::uncertainty::Covariance;

/// As for what stands, but a resting ball must differ from a slow one: sightings weigh a quarter or more.
const FADE: f32 = 4.0 / 3.0;
/// How often a resting ball begins to roll, 1/s.
const STARTS: f32 = 0.05;
/// How often a rolling ball stops, 1/s: one that is fast, at something; and one that is known to be slow.
const STOPS: (f32, f32) = (0.2, 4.0);
/// Slower than this is slow, m/s, if it is known this well, m/s.
const SLOW: (f32, f32) = (0.06, 0.3);
/// How much a ball that is seen for the first time is believed to roll.
const AT_FIRST: f32 = 0.2;
/// Neither way is believed less than this.
const LEAST: f32 = 1e-3;

/// Where the ball is and where it rolls, in the ground frame of the robot as it stands now: m, x forward, y left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallMemory {
    ball: Option<Ball>,
    belief: Belief,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Ball {
    resting: PositionEstimate,
    rolling: Rolling,
    /// How much it is believed to roll.
    rolls: f32,
    /// The covariance of what sightings have in common.
    lasting: Covariance,
}

impl BallMemory {
    /// No ball remembered yet. Confidence will halve in `half_life` seconds without a sighting; not positive or not a
    /// number: at once.
    #[must_use]
    pub const fn new(half_life: f32) -> Self {
        Self { ball: None, belief: Belief::new(half_life) }
    }

    fn ball(&self) -> Option<&Ball> {
        self.ball.as_ref().filter(|_| self.belief.is_held())
    }

    /// Where the ball is and how sure that is, if it is not forgotten.
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.ball().map(Ball::estimate)
    }

    /// Where the ball is if it does what it more likely does, rest or roll; if it is not forgotten.
    #[must_use]
    pub fn likeliest(&self) -> Option<PositionEstimate> {
        self.ball()
            .map(|ball| if ball.rolls > 0.5 { ball.rolling.estimate() } else { ball.resting }.with(&ball.lasting))
    }

    /// Where the ball is, if it is not forgotten.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        self.estimate().map(|place| place.position)
    }

    /// How much the ball is believed to roll, 0 to 1; 0 if it is forgotten.
    #[must_use]
    pub fn rolls(&self) -> f32 {
        self.ball().map_or(0.0, |ball| ball.rolls)
    }

    /// Whether the ball more likely rolls than rests.
    #[must_use]
    pub fn is_rolling(&self) -> bool {
        self.rolls() > 0.5
    }

    /// Its velocity over the ground, m/s in the robot's ground frame: that of a rolling ball, zero of a resting one.
    #[must_use]
    pub fn velocity(&self) -> Vec2 {
        self.ball().filter(|_| self.is_rolling()).map_or(Vec2::ZERO, |ball| ball.rolling.velocity())
    }

    /// Where the ball will be in so many seconds if nothing stops it, and how sure that is. A time that is not positive
    /// counts as now. After 5 s every ball rests.
    #[must_use]
    pub fn predict(&self, seconds: f32) -> Option<PositionEstimate> {
        let mut ball = *self.ball()?;
        ball.rolling.roll(sound(Pose2::ORIGIN, seconds).1);
        Some(ball.estimate())
    }

    /// How much the ball's place is believed, 0 to 1.
    #[must_use]
    pub const fn confidence(&self) -> f32 {
        self.belief.confidence()
    }

    /// Seconds since it was last seen. None if it is forgotten.
    #[must_use]
    pub fn age(&self) -> Option<f32> {
        self.ball().map(|_| self.belief.age())
    }

    /// Forgets the ball.
    pub const fn forget(&mut self) {
        self.ball = None;
        self.belief.forget();
    }

    /// Takes in a sighting: m in the robot's ground frame, its covariance, and a confidence of 0 to 1. If neither a
    /// resting nor a rolling ball would be there, the filter starts anew. What is not a number, or a covariance that is
    /// none, is not seen.
    #[inline(never)]
    pub fn see(&mut self, position: Vec2, covariance: &Covariance, confidence: f32) {
        let Some(seen) = PositionEstimate::seen(position, covariance).filter(|_| Belief::counts(confidence)) else {
            return;
        };
        let again = self.ball().copied().and_then(|ball| ball.corrected(&seen));
        self.belief.see(confidence, again.is_some());
        self.ball = Some(again.unwrap_or_else(|| Ball::new(&seen)));
    }

    /// It should have been seen and was not ([`visibility::is_in_view`](super::visibility::is_in_view)): believed a quarter less.
    pub fn miss(&mut self) {
        self.belief.miss();
    }

    /// The robot moved by `motion` (its new pose, seen from its old one) and `seconds` went by. A motion that is not
    /// a number counts as none, a time that is not positive as no time.
    #[inline(never)]
    pub fn advance(&mut self, motion: Pose2, seconds: f32) {
        let (motion, seconds) = sound(motion, seconds);
        self.belief.advance(motion, seconds);
        if !self.belief.is_held() {
            return self.forget();
        }
        if let Some(ball) = &mut self.ball {
            ball.advance(motion, seconds);
            if !ball.is_sound() {
                self.forget();
            }
        }
    }
}

impl Ball {
    fn new(seen: &PositionEstimate) -> Self {
        Self { resting: *seen, rolling: Rolling::kicked(seen), rolls: AT_FIRST, lasting: seen.covariance * LASTING }
    }

    fn estimate(&self) -> PositionEstimate {
        self.resting.mixed(&self.rolling.estimate(), self.rolls).with(&self.lasting)
    }

    fn is_sound(&self) -> bool {
        self.resting.is_sound() && self.rolling.is_sound()
    }

    fn advance(&mut self, motion: Pose2, seconds: f32) {
        self.change(seconds);
        self.rolling.roll(seconds);
        self.rolling.advance(motion);
        self.resting.advance(motion);
        self.lasting = turned(motion, &self.lasting);
    }

    /// In this time a resting ball may have been kicked, and a rolling one may have stopped.
    fn change(&mut self, seconds: f32) {
        let stopping = if self.rolling.is_slow(SLOW) { STOPS.1 } else { STOPS.0 };
        let within = |rate: f32| 1.0 - expf(-rate * seconds);
        let kicked = (1.0 - self.rolls) * within(STARTS);
        let stopped = self.rolls * within(stopping);
        let rolls = (self.rolls + kicked - stopped).clamp(LEAST, 1.0 - LEAST);
        let before = self.resting;
        self.resting = before.mixed(&self.rolling.estimate(), (stopped / (1.0 - rolls)).clamp(0.0, 1.0));
        self.rolling.mix_in_kicked(&before, (kicked / rolls).clamp(0.0, 1.0));
        self.rolls = rolls;
    }

    fn corrected(mut self, seen: &PositionEstimate) -> Option<Self> {
        self.resting = self.resting.faded(FADE);
        self.lasting = seen.covariance * LASTING;
        let (resting, rolling) = (self.resting.fit(seen)?, self.rolling.fit(seen)?);
        if resting.distance.min(rolling.distance) > GATE {
            return None;
        }
        let odds = expf((resting.likelihood - rolling.likelihood).clamp(-50.0, 50.0)) * (1.0 - self.rolls) / self.rolls;
        self.rolls = (1.0 / (1.0 + odds)).clamp(LEAST, 1.0 - LEAST);
        self.resting = self.resting.corrected(&resting);
        self.rolling.correct(&rolling);
        self.is_sound().then_some(self)
    }
}
