//! Velocity limits of a gait.

use libm::{powf, sqrtf};

use crate::bounds::clamp;
use crate::model::Parameters;
use crate::velocity::Velocity;

impl Velocity {
    /// Nearest velocity that a gait can walk. The turn has priority; the translation is reduced.
    ///
    /// With each component relative to its maximum, `(forward^1.5 + left^1.5)^(4/3) + turn^2 <= 1` (walk volume of
    /// B-Human 2023 and HULKs 2025). NaN components count as zero.
    #[must_use]
    pub fn clamped(&self, gait: &Parameters) -> Self {
        let most_forward = if self.forward < 0.0 { gait.max_backward_speed } else { gait.max_velocity.forward };
        let share = |part: f32, most: f32| if part.is_nan() { 0.0 } else { (part / most).clamp(-1e3, 1e3) };
        let (x, y) = (share(self.forward, most_forward), share(self.left, gait.max_velocity.left));
        let turn = share(self.turn, gait.max_velocity.turn).clamp(-1.0, 1.0);
        let way = powf(powf(x.abs(), 1.5) + powf(y.abs(), 1.5), 4.0 / 3.0);
        let room = 1.0 - turn * turn;
        let scale = if way > room { sqrtf(room / way) } else { 1.0 };
        Self::new(scale * x * most_forward, scale * y * gait.max_velocity.left, turn * gait.max_velocity.turn)
    }

    /// Velocity to plan so that the body moves at this velocity; zero stays zero.
    pub(super) fn planned(&self, gait: &Parameters) -> Self {
        if self.is_zero() {
            return *self;
        }
        let (drift, scale) = (&gait.velocity_drift, &gait.velocity_scale);
        Self {
            forward: scale.forward * (self.forward - drift.forward),
            left: scale.left * (self.left - drift.left),
            turn: scale.turn * (self.turn - drift.turn),
        }
    }

    /// Velocity of the next step on the way to `requested`. A component that changes its sign stops at zero first.
    #[must_use]
    pub fn toward(&self, requested: &Self, gait: &Parameters) -> Self {
        let (up, down) = (&gait.max_speed_up, &gait.max_slow_down);
        Self {
            forward: approach(self.forward, requested.forward, up.forward, down.forward),
            left: approach(self.left, requested.left, up.left, down.left),
            turn: approach(self.turn, requested.turn, up.turn, down.turn),
        }
    }
}

fn approach(now: f32, requested: f32, up: f32, down: f32) -> f32 {
    let goal = if now * requested < 0.0 { 0.0 } else { requested };
    let most = if goal.abs() > now.abs() { up } else { down };
    now + clamp(goal - now, -most, most)
}
