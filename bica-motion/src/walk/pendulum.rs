//! Linear inverted pendulum.

use glam::Vec2;
use libm::{expf, sinhf, sqrtf};

use crate::model::Parameters;

/// Gravity, m/s².
const GRAVITY: f32 = 9.81;

/// Linear inverted pendulum during one step (Kajita and Tani 1991): the horizontal acceleration of the body is proportional
/// to its distance from the support foot, so the ankle needs no torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pendulum {
    /// Duration of the step times the pendulum's natural frequency.
    whole: f32,
    sinh_whole: f32,
}

impl Pendulum {
    /// Pendulum of the gait in a step of `duration` s; `None` for a quasi-static gait.
    pub(super) fn new(gait: &Parameters, duration: f32) -> Option<Self> {
        let whole = duration * sqrtf(GRAVITY / gait.pendulum_height);
        (gait.pendulum_height > 0.0).then(|| Self { whole, sinh_whole: sinhf(whole) })
    }

    /// Position of the body at a phase of its motion between two positions, in the frame of the support foot, m.
    pub(super) fn between(self, ends: &[Vec2; 2], phase: f32) -> Vec2 {
        let share = |part: f32| sinhf(self.whole * part) / self.sinh_whole;
        share(1.0 - phase) * ends[0] + share(phase) * ends[1]
    }

    /// Divergent component of this motion at a phase, in the frame of the support foot, m.
    pub(super) fn dcm(self, ends: &[Vec2; 2], phase: f32) -> Vec2 {
        (expf(self.whole * phase) * ends[1] - expf(self.whole * (phase - 1.0)) * ends[0]) / self.sinh_whole
    }

    /// Natural frequency, 1/s, if the step takes `duration` s.
    pub(super) const fn frequency(self, duration: f32) -> f32 {
        self.whole / duration
    }
}
