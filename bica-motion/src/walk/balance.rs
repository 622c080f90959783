//! Balance from the inertial unit: corrections of the ankles, of the next footprint and of the gait phase.
//!
//! The *capture point* of a body is the point where it must step to come to rest: its position plus its velocity
//! divided by the pendulum's natural frequency (Pratt et al. 2006). The error is the difference between the actual and
//! the planned capture point. It is computed from tilt and angular rate of the torso only.

use core::f32::consts::PI;

use glam::Vec2;
use libm::sqrtf;

use crate::bounds::clamp;
use crate::easing::smooth;
use crate::model::{Parameters, RobotModel};
use crate::walk::Feedback;

/// Maximum correction of an ankle angle, rad.
const MAX_ANKLE_CORRECTION: f32 = 0.1;
/// Gravity, m/s².
const GRAVITY: f32 = 9.81;
/// Maximum angular rate, rad/s: the measuring range of the gyroscope, 2000°/s.
const MAX_RATE: f32 = 35.0;

/// Angular rates of the torso and capture-point error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Balance {
    /// Rates of roll and pitch, low-pass filtered, rad/s.
    rates: Vec2,
    /// Displacement of the capture point from its place under an upright, still torso, m: forward and left.
    capture_error: Vec2,
}

impl Balance {
    pub(crate) const fn new() -> Self {
        Self { rates: Vec2::ZERO, capture_error: Vec2::ZERO }
    }

    /// Processes the measurements of one cycle; `lean` is the lean of the torso, rad, in addition to the gait's. NaN
    /// and infinite values count as zero.
    pub(crate) fn update(&mut self, model: &RobotModel, feedback: &Feedback, gait: &Parameters, lean: f32) {
        let sane = |x: f32, most: f32| if x.is_finite() { clamp(x, -most, most) } else { 0.0 };
        let rates = Vec2::new(sane(feedback.gyro.x, MAX_RATE), sane(feedback.gyro.y, MAX_RATE));
        self.rates += (1.0 - gait.gyro_smoothing) * (rates - self.rates);
        let height = gait.hip_height + model.dimensions.mass_over_hips;
        let frequency = sqrtf(GRAVITY / height);
        let tilt = Vec2::new(sane(feedback.pitch, PI) - (gait.torso_pitch + lean), -sane(feedback.roll, PI));
        self.capture_error = height * (tilt + Vec2::new(rates.y, -rates.x) / frequency);
    }

    /// Corrections of pitch and roll of the support ankle in walking, rad, with the gains scaled by `scale`. A fall to the
    /// front presses the toes down.
    pub(super) fn ankle(&self, gait: &Parameters, scale: f32) -> [f32; 2] {
        let most = MAX_ANKLE_CORRECTION;
        let pitch = clamp(scale * gait.ankle_pitch_gain * self.rates.y, -most, most);
        let roll = clamp(scale * gait.ankle_roll_gain * self.rates.x, -most, most);
        [pitch, roll]
    }

    /// Corrections of pitch and roll of an ankle in stand or in a kick, rad, with the gains scaled by `scale`.
    pub(crate) fn standing(&self, gait: &Parameters, scale: f32) -> [f32; 2] {
        let most = MAX_ANKLE_CORRECTION;
        let pitch = clamp(scale * gait.stand_ankle_gain.y * self.rates.y, -most, most);
        let roll = clamp(scale * gait.stand_ankle_gain.x * self.rates.x, -most, most);
        [pitch, roll]
    }

    /// Displacement of the capture point from its place under an upright, still torso, m: forward and left.
    pub(super) const fn capture_error(&self) -> Vec2 {
        self.capture_error
    }
}

impl Parameters {
    /// The part of a displacement of the DCM that an undisturbed step does not have at this phase, beyond the deadband, m: forward, and
    /// toward the swing foot. `offset` is the usual one at the middle of a step.
    pub(super) fn beyond_usual(&self, displacement: Vec2, offset: Vec2, phase: f32) -> Vec2 {
        let sway = self.capture_sway * (2.0 * smooth(phase) - 1.0);
        let error = displacement - (offset + Vec2::new(0.0, sway));
        error - error.clamp(-self.capture_deadband, self.capture_deadband)
    }
}
