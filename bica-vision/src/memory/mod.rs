//! Perceptual memory: where a stimulus is while nobody looks at it.
//!
//! A remembered place moves against the robot's own motion (odometry), is surer the more often it is seen, and is
//! believed less and less sure with time and with the way walked. [`Memory`] is for what stands, [`ball::BallMemory`]
//! for what may roll, [`multi_target::MultiTargetMemory`] for things that look alike. [`sight`] tells what should be visible, so that what is not there is forgotten.
//! What they hold is always a number. Cost: 50 ns for each motion or sighting of a `Memory`.

pub mod ball;
mod belief;
pub mod multi_target;
mod position_estimate;
mod rolling;
pub mod visibility;

use bica_motion::pose::Pose2;
use glam::Vec2;

use self::belief::Belief;
pub use self::position_estimate::PositionEstimate;
use self::position_estimate::{GATE, turned};
use crate::uncertainty::Covariance;

/// By how much the covariance grows before a sighting is weighed: this keeps the weight of a sighting at a half or more,
/// for what the filter does not know of (a fading memory, Sorenson and Sacks 1971).
const FADE: f32 = 2.0;
/// The part of a sighting's covariance that the next sightings share, as errors of the camera's pose last for many images:
/// it does not average out.
const LASTING: f32 = 0.25;

/// A remembered place on the ground, in the ground frame of the robot as it stands now: m, x forward, y left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    known: Option<Known>,
    belief: Belief,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Known {
    /// As far as sightings differ from each other.
    place: PositionEstimate,
    /// The covariance of what they have in common.
    lasting: Covariance,
}

impl Memory {
    /// Nothing remembered yet. Confidence will halve in `half_life` seconds without a sighting; not positive or not a
    /// number: at once.
    #[must_use]
    pub const fn new(half_life: f32) -> Self {
        Self { known: None, belief: Belief::new(half_life) }
    }

    /// The place and how sure it is, if it is not forgotten.
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.known().map(|known| known.place.with(&known.lasting))
    }

    fn known(&self) -> Option<&Known> {
        self.known.as_ref().filter(|_| self.belief.is_held())
    }

    /// The place, if it is not forgotten.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        self.estimate().map(|place| place.position)
    }

    /// How much the place is believed, 0 to 1.
    #[must_use]
    pub const fn confidence(&self) -> f32 {
        self.belief.confidence()
    }

    /// Seconds since it was last seen. None if nothing is remembered.
    #[must_use]
    pub fn age(&self) -> Option<f32> {
        self.known().map(|_| self.belief.age())
    }

    /// Forgets the place.
    pub const fn forget(&mut self) {
        self.known = None;
        self.belief.forget();
    }

    /// How many squared deviations a sighting is off the remembered place; none if nothing is remembered, or the
    /// sighting is no number.
    #[must_use]
    pub fn distance(&self, position: Vec2, covariance: &Covariance) -> Option<f32> {
        let fit = self.estimate()?.fit(&PositionEstimate::seen(position, covariance)?)?;
        Some(fit.distance)
    }

    /// Takes in a sighting: m in the robot's ground frame, its covariance, and a confidence of 0 to 1. Close to the
    /// remembered place, as deviations go, both are weighed by their covariances, else the new one stands. What is not
    /// a number, or a covariance that is none, is not seen.
    pub fn see(&mut self, position: Vec2, covariance: &Covariance, confidence: f32) {
        let Some(seen) = PositionEstimate::seen(position, covariance).filter(|_| Belief::counts(confidence)) else {
            return;
        };
        let faded = self.known().map(|known| known.place.faded(FADE));
        let fit = faded.and_then(|faded| Some((faded, faded.fit(&seen).filter(|fit| fit.distance <= GATE)?)));
        let again = fit.map(|(faded, fit)| faded.corrected(&fit)).filter(PositionEstimate::is_sound);
        self.belief.see(confidence, again.is_some());
        self.known = Some(Known { place: again.unwrap_or(seen), lasting: seen.covariance * LASTING });
    }

    /// It should have been seen and was not ([`visibility::is_in_view`]): believed a quarter less.
    pub fn miss(&mut self) {
        self.belief.miss();
    }

    /// The robot moved by `motion` (its new pose, seen from its old one) and `seconds` went by. A motion that is not
    /// a number counts as none, a time that is not positive as no time.
    pub fn advance(&mut self, motion: Pose2, seconds: f32) {
        let (motion, seconds) = sound(motion, seconds);
        self.belief.advance(motion, seconds);
        let Some(mut known) = self.known().copied() else { return self.forget() };
        known.place.advance(motion);
        known.lasting = turned(motion, &known.lasting);
        self.known = Some(known);
        if !known.place.is_sound() {
            self.forget();
        }
    }
}

/// A motion and a time that are numbers.
fn sound(motion: Pose2, seconds: f32) -> (Pose2, f32) {
    let is_finite = motion.position.is_finite() && motion.heading.is_finite();
    (if is_finite { motion } else { Pose2::ORIGIN }, if seconds > 0.0 { seconds } else { 0.0 })
}
