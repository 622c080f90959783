//! Lateral weight shift of the quasi-static gait.

use core::f32::consts::FRAC_PI_2;

use libm::{asinf, sinf};

use crate::easing::smooth;
use crate::model::Parameters;

/// Weight shift at one end of a step: the hips move from between the feet to the support foot, or back if reversed in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct WeightShift {
    /// Duration, s.
    duration: f32,
    /// Time after which the support foot alone can hold the body, s.
    pub(super) double_support: f32,
    /// Whether the shift begins at rest, as from a stand.
    from_rest: bool,
}

impl WeightShift {
    /// Shift from `distance` m lateral of the support ankle, beginning at the gait's sway speed. It is empty in a gait with a
    /// pendulum.
    pub(super) fn new(distance: f32, gait: &Parameters) -> Self {
        let (whole, unsafe_part) = (distance - gait.mid_step_hip_offset, distance - gait.single_support_hip_offset);
        if whole <= 0.0 || gait.pendulum_height > 0.0 {
            return Self { duration: 0.0, double_support: 0.0, from_rest: false };
        }
        let duration = FRAC_PI_2 * whole / gait.max_sway_speed;
        let double_support = duration / FRAC_PI_2 * asinf((unsafe_part / whole).clamp(0.0, 1.0));
        Self { duration, double_support, from_rest: false }
    }

    /// Shift that begins at rest and takes half of a step.
    pub(super) fn from_rest(step_duration: f32) -> Self {
        Self { duration: 0.5 * step_duration, double_support: 0.5 * step_duration, from_rest: true }
    }

    /// Completed share of the shift `t` s after the weight is between the feet (or before, if reversed), 0 to 1.
    pub(super) fn at(&self, t: f32) -> f32 {
        let part = if self.duration > 0.0 { (t / self.duration).clamp(0.0, 1.0) } else { 1.0 };
        if self.from_rest { smooth(part) } else { sinf(FRAC_PI_2 * part) }
    }
}
