//! Perceptual memory: Kalman filters for objects that are out of view.
//!
//! Odometry moves each remembered position in the robot's frame. Sightings reduce its covariance; time and walked distance increase
//! it and reduce the confidence. [`Memory`] is for static objects, [`ball::BallMemory`] for the ball,
//! [`multi_target::MultiTargetMemory`] for several objects of one kind. [`visibility`] computes whether an object should be in
//! view, so a missing object is forgotten. All results are finite. Cost: 50 ns for each motion or sighting of a `Memory`.

pub mod ball;
mod belief;
pub mod multi_target;
mod position_estimate;
mod rolling;
mod tuning;
pub mod visibility;

use bica_motion::pose::Pose2;
use glam::Vec2;

use self::belief::Belief;
pub use self::position_estimate::PositionEstimate;
use self::position_estimate::{GATE, turned};
pub use self::tuning::{BallMemoryTuning, MemoryTuning};
use crate::uncertainty::Covariance;

/// Factor on the covariance before each update (fading-memory filter, Sorenson and Sacks 1971). It keeps the gain at
/// 0.5 or more, which covers unmodelled changes.
const FADE: f32 = 2.0;
/// Share of a sighting's covariance that consecutive sightings have in common: errors of the camera pose persist over
/// many images and do not average out.
const LASTING: f32 = 0.25;

/// Remembered position of a static object, in the robot's present ground frame: m, x forward, y left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    known: Option<Known>,
    belief: Belief,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Known {
    /// Estimate from the independent part of the errors.
    place: PositionEstimate,
    /// Covariance of the errors that sightings have in common.
    lasting: Covariance,
}

impl Memory {
    /// Creates an empty memory. Without sightings the confidence halves every `half_life` seconds; at once if
    /// `half_life` is not positive or NaN.
    #[must_use]
    pub const fn new(half_life: f32) -> Self {
        Self { known: None, belief: Belief::new(MemoryTuning { half_life, ..MemoryTuning::DEFAULT }) }
    }

    /// Sets the rates and errors to use from now on.
    pub const fn set_tuning(&mut self, tuning: &MemoryTuning) {
        self.belief.tuning = *tuning;
    }

    /// Position with covariance, unless forgotten.
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.known().map(|known| known.place.with(&known.lasting))
    }

    fn known(&self) -> Option<&Known> {
        self.known.as_ref().filter(|_| self.belief.is_held())
    }

    /// Position, m, unless forgotten.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        self.estimate().map(|place| place.position)
    }

    /// Confidence in the position, 0 to 1.
    #[must_use]
    pub const fn confidence(&self) -> f32 {
        self.belief.confidence()
    }

    /// Time since the last sighting, s. `None` if nothing is remembered.
    #[must_use]
    pub fn age(&self) -> Option<f32> {
        self.known().map(|_| self.belief.age())
    }

    /// Forgets the object.
    pub const fn forget(&mut self) {
        self.known = None;
        self.belief.forget();
    }

    /// Squared Mahalanobis distance of a sighting from the remembered position; `None` if nothing is remembered or the
    /// sighting is not finite.
    #[must_use]
    pub fn distance(&self, position: Vec2, covariance: &Covariance) -> Option<f32> {
        let fit = self.estimate()?.fit(&PositionEstimate::seen(position, covariance)?)?;
        Some(fit.distance)
    }

    /// Processes a sighting: position in the robot's ground frame, m, its covariance, and a confidence of 0 to 1.
    ///
    /// A sighting within the gate updates the estimate, any other replaces it. A sighting that is not finite or has no
    /// positive definite covariance is ignored.
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

    /// Notes that the object was not seen although in view ([`visibility::is_in_view`]): reduces the confidence by
    /// [`MemoryTuning::miss_factor`].
    pub fn miss(&mut self) {
        self.belief.miss();
    }

    /// Applies the robot's `motion` (new pose in the old one's frame) and `seconds` of time. A motion that is not
    /// finite counts as none, a time that is not positive as zero.
    pub fn advance(&mut self, motion: Pose2, seconds: f32) {
        let (motion, seconds) = sound(motion, seconds);
        self.belief.advance(motion, seconds);
        let Some(mut known) = self.known().copied() else { return self.forget() };
        known.place.advance(motion, &self.belief.tuning);
        known.lasting = turned(motion, &known.lasting);
        self.known = Some(known);
        if !known.place.is_sound() {
            self.forget();
        }
    }
}

/// Motion and time with invalid values replaced.
fn sound(motion: Pose2, seconds: f32) -> (Pose2, f32) {
    let is_finite = motion.position.is_finite() && motion.heading.is_finite();
    (if is_finite { motion } else { Pose2::ORIGIN }, if seconds > 0.0 { seconds } else { 0.0 })
}
