//! How fast to walk: what is asked for and what a gait can give.

use crate::bounds::clamp;
use libm::{powf, sqrtf};

use crate::walk::Parameters;

/// A velocity over the ground, seen from the robot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity {
    /// m/s.
    pub forward: f32,
    /// m/s; negative to the right.
    pub left: f32,
    /// rad/s, counter-clockwise.
    pub turn: f32,
}

impl Velocity {
    /// Standing.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);

    /// A velocity from its parts.
    #[must_use]
    pub const fn new(forward: f32, left: f32, turn: f32) -> Self {
        Self { forward, left, turn }
    }

    /// Whether every part is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.forward == 0.0 && self.left == 0.0 && self.turn == 0.0
    }

    /// The nearest velocity that a gait can walk: turning goes first, the way gives way.
    ///
    /// With each part as a share of its most, `(forward^1.5 + left^1.5)^(4/3) + turn^2 <= 1` (the walk volume of
    /// B-Human 2023 and HULKs 2025). Parts that are no numbers count as zero.
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

    /// What to plan so that the body goes like this; standing stays standing.
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

    /// The next step's velocity on the way from this one to `wanted`; a part that changes its sign stops at zero first.
    #[must_use]
    pub fn toward(&self, wanted: &Self, gait: &Parameters) -> Self {
        let part = |now, wanted, up, down| approach(now, wanted, up, down);
        Self {
            forward: part(self.forward, wanted.forward, gait.max_speed_up.forward, gait.max_slow_down.forward),
            left: part(self.left, wanted.left, gait.max_speed_up.left, gait.max_slow_down.left),
            turn: part(self.turn, wanted.turn, gait.max_speed_up.turn, gait.max_slow_down.turn),
        }
    }
}

fn approach(now: f32, wanted: f32, up: f32, down: f32) -> f32 {
    let goal = if now * wanted < 0.0 { 0.0 } else { wanted };
    let most = if goal.abs() > now.abs() { up } else { down };
    now + clamp(goal - now, -most, most)
}
