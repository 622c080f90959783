//! Counter of repetitions, sample by sample.

use glam::Vec3;

use super::Seen;
use super::repetition::{Repetition, Samples};

/// Time constant of the smoothed angle that separates repetitions, s.
const SMOOTHING: f32 = 0.12;
/// Rise of the arm with which a repetition begins, degrees.
const RISE: f32 = 15.0;
/// Fraction of its rise at or below which the falling arm ends a repetition.
const END: f32 = 0.3;
/// Time constant with which the lowest angle follows a resting arm, s.
const FOLLOWING: f32 = 2.0;
/// Rise above the lowest angle up to which the arm counts as resting, degrees.
const RESTING: f32 = 5.0;

/// Direction of the resting arm, and plane of its movement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reference {
    /// Direction of the resting arm, unit length.
    pub(crate) rest: Vec3,
    /// Normal of the plane of the movement, unit length; `None` until it is known.
    pub(crate) normal: Option<Vec3>,
}

impl Reference {
    /// Angle of an arm from its rest, degrees: in the plane, -90 to 270; without a known plane the angle in space, 0 to 180.
    pub(crate) fn angle(&self, arm: Vec3) -> f32 {
        let Some(normal) = self.normal else { return self.rest.angle_between(arm).to_degrees() };
        let rest = self.rest.reject_from(normal).normalize_or_zero();
        let angle = libm::atan2f(normal.dot(rest.cross(arm)), rest.dot(arm)).to_degrees();
        if angle < -90.0 { angle + 360.0 } else { angle }
    }
}

/// Separates repetitions: in each the arm rises from its lowest angle and falls again.
#[derive(Clone, Debug)]
pub(crate) struct Counter {
    pub(crate) reference: Reference,
    samples: Samples,
    smooth: Option<f32>,
    low: f32,
    high: f32,
    raised: bool,
}

impl Counter {
    /// A counter that begins with a resting arm.
    pub(crate) const fn new(reference: Reference) -> Self {
        Self { reference, samples: Samples::new(), smooth: None, low: 0.0, high: 0.0, raised: false }
    }

    /// Processes a sample of trunk and arm, `dt` seconds after the previous one. Returns a repetition that ends with it.
    pub(crate) fn push(&mut self, seen: Option<Seen>, dt: f32) -> Option<Repetition> {
        self.samples.push(seen, dt);
        let angle = self.reference.angle(seen?.arm);
        let smooth = self.smooth.map_or(angle, |old| old + (1.0 - libm::expf(-dt / SMOOTHING)) * (angle - old));
        self.low = if self.smooth.is_none() { smooth } else { self.low };
        self.smooth = Some(smooth);
        if self.raised {
            self.high = self.high.max(smooth);
            let end = self.low + END * (self.high - self.low);
            return (smooth < end).then(|| self.close(smooth));
        }
        self.low = self.low.min(smooth);
        if smooth < self.low + RESTING {
            self.samples.keep_last();
        }
        self.low += (smooth - self.low) * (dt / FOLLOWING).min(1.0);
        (self.raised, self.high) = (smooth > self.low + RISE, smooth);
        None
    }

    /// Ends the stream; returns the repetition that has begun, if any.
    pub(crate) fn finish(&mut self) -> Option<Repetition> {
        let ended = self.raised.then(|| self.close(0.0));
        *self = Self::new(self.reference);
        ended
    }

    fn close(&mut self, low: f32) -> Repetition {
        (self.low, self.raised) = (low, false);
        let ended = Repetition::of(&self.samples, &self.reference);
        self.samples = Samples::new();
        ended
    }
}
