//! Staying upright: what the inertial unit adds to the ankles, to the next footprint and to the time.
//!
//! A body that leans and turns falls as a pendulum does. Where it would have to stand to come to rest is its *capture
//! point*: its own place plus its velocity over the pendulum's pace (Pratt et al. 2006). Tilt and rate of the torso say
//! how far that point is from where the plan has it; joints need not be measured for it.

use crate::bounds::clamp;
use core::f32::consts::PI;

use glam::Vec2;
use libm::sqrtf;

use crate::easing::smooth;
use crate::walk::{Feedback, Parameters};

/// The most that balance turns an ankle, rad.
const MOST: f32 = 0.1;
/// The centre of mass over the hips, m: a NAO in stand.
const MASS_OVER_HIPS: f32 = 0.035;
/// Gravity, m/s².
const GRAVITY: f32 = 9.81;
/// The most that a catching step brings the feet closer together than planned, m.
const MOST_INWARDS: f32 = 0.01;
/// The fastest turning that is believed, rad/s: 2000° a second, the most that such gyroscopes measure.
const MOST_RATE: f32 = 35.0;
/// However far it is off, time passes at this share of its speed.
const SLOWEST: f32 = 0.1;

/// How the torso moves, and how far its capture point is off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Balance {
    /// Rates of roll and pitch, smoothed, rad/s.
    rates: Vec2,
    /// The capture point from where it would be under an upright, still torso, m: forward and left.
    off: Vec2,
}

impl Balance {
    pub(crate) const fn new() -> Self {
        Self { rates: Vec2::ZERO, off: Vec2::ZERO }
    }

    /// Takes a cycle's measurements. What is no number counts as none.
    pub(crate) fn feel(&mut self, body: &Feedback, gait: &Parameters) {
        let sane = |x: f32, most: f32| if x.is_finite() { clamp(x, -most, most) } else { 0.0 };
        let rates = Vec2::new(sane(body.gyro.x, MOST_RATE), sane(body.gyro.y, MOST_RATE));
        self.rates += (1.0 - gait.gyro_smoothing) * (rates - self.rates);
        let height = gait.hip_height + MASS_OVER_HIPS;
        let pace = sqrtf(GRAVITY / height);
        let tilt = Vec2::new(sane(body.pitch, PI) - gait.torso_pitch, -sane(body.roll, PI));
        self.off = height * (tilt + Vec2::new(rates.y, -rates.x) / pace);
    }

    /// What to add to the carrying ankle's pitch and roll, rad: a fall forward presses the toes down.
    pub(super) fn ankle(&self, gait: &Parameters) -> [f32; 2] {
        [
            (gait.ankle_pitch_gain * self.rates.y).clamp(-MOST, MOST),
            (gait.ankle_roll_gain * self.rates.x).clamp(-MOST, MOST),
        ]
    }

    /// What to add to the pitch and roll of an ankle that stands still, rad.
    pub(crate) fn standing(&self, gait: &Parameters) -> [f32; 2] {
        [
            (gait.stand_ankle_gain.y * self.rates.y).clamp(-MOST, MOST),
            (gait.stand_ankle_gain.x * self.rates.x).clamp(-MOST, MOST),
        ]
    }

    /// How far the capture point is off at a share `part` of a step: forward, and toward the swinging foot on the side
    /// with that `sign`, m.
    pub(super) fn off(&self, sign: f32, part: f32, gait: &Parameters) -> Vec2 {
        let rocked = gait.capture_sway * (2.0 * smooth(part) - 1.0);
        Vec2::new(self.off.x, sign * self.off.y - rocked)
    }
}

impl Parameters {
    /// How far from its plan the swinging foot comes down when the capture point is `off`, m.
    pub(super) fn catch(&self, off: Vec2) -> Vec2 {
        let beyond = off - off.clamp(-self.capture_deadband, self.capture_deadband);
        let moved = (self.capture_gain * beyond).clamp(-self.max_capture_step, self.max_capture_step);
        moved.with_y(moved.y.max(-MOST_INWARDS))
    }

    /// How fast time passes when the capture point is `off`, 1 when all is well.
    pub(super) fn pace(&self, off: Vec2) -> f32 {
        let outwards = (-off.y - self.capture_deadband.y).max(0.0);
        (1.0 - self.phase_slowdown * outwards).max(SLOWEST)
    }
}
