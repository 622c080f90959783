//! Staying upright: what the gyroscope adds to the ankles.

use crate::walk::Parameters;

/// The most that balance turns an ankle, rad.
const MOST: f32 = 0.1;

/// The pitch rate, smoothed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Balance {
    pitch_rate: f32,
}

impl Balance {
    pub(super) const fn new() -> Self {
        Self { pitch_rate: 0.0 }
    }

    /// What to add to the carrying ankle's pitch, rad, after a cycle in which the torso pitched at `pitch_rate` rad/s:
    /// a fall forward presses the toes down. A rate that is no number counts as none.
    pub(super) fn ankle_pitch(&mut self, pitch_rate: f32, gait: &Parameters) -> f32 {
        let rate = if pitch_rate.is_finite() { pitch_rate } else { 0.0 };
        self.pitch_rate += (1.0 - gait.gyro_smoothing) * (rate - self.pitch_rate);
        (gait.ankle_gain * self.pitch_rate).clamp(-MOST, MOST)
    }
}
