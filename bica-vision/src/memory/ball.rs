//! Memory of the ball, which rests or rolls.
//!
//! An interacting multiple model filter (IMM, Blom and Bar-Shalom 1988) of two Kalman filters: one for a resting ball
//! (position) and one for a rolling ball (position and velocity, with rolling friction). At each step each filter takes
//! over a share of the other for the probability of a kick or a stop. Sightings weight them by likelihood.
//!
//! Cost: 0.4 µs for each motion, 0.2 µs for each sighting.

use bica_motion::pose::Pose2;
use glam::Vec2;
use libm::expf;

use super::belief::Belief;
use super::position_estimate::{GATE, PositionEstimate, turned};
use super::rolling::Rolling;
use super::{BallMemoryTuning, LASTING, MemoryTuning, sound};
use crate::uncertainty::Covariance;

/// Factor on the covariance before each update; lower than for static objects, to distinguish a resting from a slow ball.
const FADE: f32 = 4.0 / 3.0;
/// Rate at which a slow ball stops, 1/s.
const SLOW_STOPS: f32 = 4.0;
/// Maximum speed of a slow ball, m/s.
const SLOW: f32 = 0.06;
/// Maximum standard deviation of the velocity of a slow ball, m/s.
const SLOW_DEVIATION: f32 = 0.3;
/// Initial probability that the ball rolls.
const AT_FIRST: f32 = 0.2;
/// Minimum probability of each model.
const LEAST: f32 = 1e-3;

/// Remembered ball in the robot's present ground frame: m, x forward, y left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallMemory {
    ball: Option<Ball>,
    belief: Belief,
    tuning: BallMemoryTuning,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Ball {
    resting: PositionEstimate,
    rolling: Rolling,
    /// Probability that the ball rolls.
    rolls: f32,
    /// Covariance of the errors that sightings have in common.
    lasting: Covariance,
}

impl BallMemory {
    /// Creates an empty memory. Without sightings the confidence halves every `half_life` seconds; at once if
    /// `half_life` is not positive or NaN.
    #[must_use]
    pub const fn new(half_life: f32) -> Self {
        let memory = MemoryTuning { half_life, ..MemoryTuning::DEFAULT };
        let tuning = BallMemoryTuning { memory, ..BallMemoryTuning::DEFAULT };
        Self { ball: None, belief: Belief::new(memory), tuning }
    }

    /// Sets the rates and errors to use from now on.
    pub const fn set_tuning(&mut self, tuning: &BallMemoryTuning) {
        self.belief.tuning = tuning.memory;
        self.tuning = *tuning;
    }

    fn ball(&self) -> Option<&Ball> {
        self.ball.as_ref().filter(|_| self.belief.is_held())
    }

    /// Position with covariance, over both models, unless forgotten.
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.ball().map(Ball::estimate)
    }

    /// Position with covariance of the more probable model, unless forgotten.
    #[must_use]
    pub fn likeliest(&self) -> Option<PositionEstimate> {
        self.ball()
            .map(|ball| if ball.rolls > 0.5 { ball.rolling.estimate() } else { ball.resting }.with(&ball.lasting))
    }

    /// Position, m, unless forgotten.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        self.estimate().map(|place| place.position)
    }

    /// Probability that the ball rolls, 0 to 1; 0 if it is forgotten.
    #[must_use]
    pub fn rolls(&self) -> f32 {
        self.ball().map_or(0.0, |ball| ball.rolls)
    }

    /// Whether rolling is the more probable model.
    #[must_use]
    pub fn is_rolling(&self) -> bool {
        self.rolls() > 0.5
    }

    /// Velocity over the ground, m/s, in the robot's ground frame; zero for a resting ball.
    #[must_use]
    pub fn velocity(&self) -> Vec2 {
        self.ball().filter(|_| self.is_rolling()).map_or(Vec2::ZERO, |ball| ball.rolling.velocity())
    }

    /// Predicted position in `seconds` if nothing stops the ball, with covariance. A time that is not positive counts
    /// as zero. After 5 s every ball rests.
    #[must_use]
    pub fn predict(&self, seconds: f32) -> Option<PositionEstimate> {
        let mut ball = *self.ball()?;
        ball.rolling.roll(sound(Pose2::ORIGIN, seconds).1, self.tuning.deceleration);
        Some(ball.estimate())
    }

    /// Confidence in the position, 0 to 1.
    #[must_use]
    pub const fn confidence(&self) -> f32 {
        self.belief.confidence()
    }

    /// Time since the last sighting, s. `None` if the ball is forgotten.
    #[must_use]
    pub fn age(&self) -> Option<f32> {
        self.ball().map(|_| self.belief.age())
    }

    /// Forgets the ball.
    pub const fn forget(&mut self) {
        self.ball = None;
        self.belief.forget();
    }

    /// Processes a sighting: position in the robot's ground frame, m, its covariance, and a confidence of 0 to 1.
    ///
    /// A sighting outside the gates of both models restarts the filter. A sighting that is not finite or has no
    /// positive definite covariance is ignored.
    #[inline(never)]
    pub fn see(&mut self, position: Vec2, covariance: &Covariance, confidence: f32) {
        let Some(seen) = PositionEstimate::seen(position, covariance).filter(|_| Belief::counts(confidence)) else {
            return;
        };
        let again = self.ball().copied().and_then(|ball| ball.corrected(&seen));
        self.belief.see(confidence, again.is_some());
        self.ball = Some(again.unwrap_or_else(|| Ball::new(&seen, &self.tuning)));
    }

    /// Notes that the ball was not seen although in view: reduces the confidence by [`MemoryTuning::miss_factor`].
    pub fn miss(&mut self) {
        self.belief.miss();
    }

    /// Applies the robot's `motion` (new pose in the old one's frame) and `seconds` of time. A motion that is not
    /// finite counts as none, a time that is not positive as zero.
    #[inline(never)]
    pub fn advance(&mut self, motion: Pose2, seconds: f32) {
        let (motion, seconds) = sound(motion, seconds);
        self.belief.advance(motion, seconds);
        if !self.belief.is_held() {
            return self.forget();
        }
        if let Some(ball) = &mut self.ball {
            ball.advance(motion, seconds, &self.tuning);
            if !ball.is_sound() {
                self.forget();
            }
        }
    }
}

impl Ball {
    fn new(seen: &PositionEstimate, tuning: &BallMemoryTuning) -> Self {
        Self {
            resting: *seen,
            rolling: Rolling::kicked(seen, tuning),
            rolls: AT_FIRST,
            lasting: seen.covariance * LASTING,
        }
    }

    fn estimate(&self) -> PositionEstimate {
        self.resting.mixed(&self.rolling.estimate(), self.rolls).with(&self.lasting)
    }

    fn is_sound(&self) -> bool {
        self.resting.is_sound() && self.rolling.is_sound()
    }

    fn advance(&mut self, motion: Pose2, seconds: f32, tuning: &BallMemoryTuning) {
        self.change(seconds, tuning);
        self.rolling.roll(seconds, tuning.deceleration);
        self.rolling.advance(motion, tuning);
        self.resting.advance(motion, &tuning.memory);
        self.lasting = turned(motion, &self.lasting);
    }

    /// Mixes the models for kicks and stops during this time.
    fn change(&mut self, seconds: f32, tuning: &BallMemoryTuning) {
        let stopping = if self.rolling.is_slow(SLOW, SLOW_DEVIATION) { SLOW_STOPS } else { tuning.stop_rate };
        let within = |rate: f32| 1.0 - expf(-rate * seconds);
        let kicked = (1.0 - self.rolls) * within(tuning.kick_rate);
        let stopped = self.rolls * within(stopping);
        let rolls = (self.rolls + kicked - stopped).clamp(LEAST, 1.0 - LEAST);
        let before = self.resting;
        self.resting = before.mixed(&self.rolling.estimate(), (stopped / (1.0 - rolls)).clamp(0.0, 1.0));
        self.rolling.mix_in_kicked(&before, (kicked / rolls).clamp(0.0, 1.0), tuning);
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
