//! The weight's way from foot to foot.

use core::f32::consts::FRAC_PI_2;

use libm::{asinf, sinf};

use crate::easing::smooth;
use crate::walk::Parameters;

/// One end of a step: the hips come from between the feet to the foot that carries, or, run backwards, leave it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shift {
    /// How long the way takes, s.
    time: f32,
    /// When the carrying foot alone holds the body, s.
    pub(super) clear: f32,
    /// Whether it begins at rest, as from a stand.
    gentle: bool,
}

impl Shift {
    /// The way from `distance` m sideways of the carrying ankle. It begins at the gait's sway speed; in a gait that rocks
    /// there is none.
    pub(super) fn from(distance: f32, gait: &Parameters) -> Self {
        let (whole, unsafe_part) = (distance - gait.mid_step_hip_offset, distance - gait.single_support_hip_offset);
        if whole <= 0.0 || gait.pendulum_height > 0.0 {
            return Self { time: 0.0, clear: 0.0, gentle: false };
        }
        let time = FRAC_PI_2 * whole / gait.max_sway_speed;
        let clear = time / FRAC_PI_2 * asinf((unsafe_part / whole).clamp(0.0, 1.0));
        Self { time, clear, gentle: false }
    }

    /// The same way from or to rest, in half of a step.
    pub(super) fn gentle(duration: f32) -> Self {
        Self { time: 0.5 * duration, clear: 0.5 * duration, gentle: true }
    }

    /// Which share of the way is done `t` s after (or before) the weight is between the feet.
    pub(super) fn at(&self, t: f32) -> f32 {
        let part = if self.time > 0.0 { (t / self.time).clamp(0.0, 1.0) } else { 1.0 };
        if self.gentle { smooth(part) } else { sinf(FRAC_PI_2 * part) }
    }
}
