//! A body that rocks.

use glam::Vec2;
use libm::{sinhf, sqrtf};

use crate::walk::Parameters;

/// Gravity, m/s².
const GRAVITY: f32 = 9.81;

/// A linear inverted pendulum during one step (Kajita and Tani 1991): over the foot it speeds up in proportion to its
/// distance from it, so no ankle has to push.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pendulum {
    /// The step's duration in the pendulum's own time.
    whole: f32,
    sinh_whole: f32,
}

impl Pendulum {
    /// The gait's pendulum in a step of `duration` s; `None` if the gait leads the body.
    pub(super) fn new(gait: &Parameters, duration: f32) -> Option<Self> {
        let whole = duration * sqrtf(GRAVITY / gait.pendulum_height);
        (gait.pendulum_height > 0.0).then(|| Self { whole, sinh_whole: sinhf(whole) })
    }

    /// Where the body is at a share of its way between two places, both seen from the foot.
    pub(super) fn between(self, ends: &[Vec2; 2], part: f32) -> Vec2 {
        let share = |part: f32| sinhf(self.whole * part) / self.sinh_whole;
        share(1.0 - part) * ends[0] + share(part) * ends[1]
    }
}
