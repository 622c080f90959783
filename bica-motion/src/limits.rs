//! How far each joint turns.
//!
//! Source: B-Human 2023 `jointLimits.cfg` and rUNSWift 2019 `bodyV6.hpp`, which agree. What
//! the head's pitch may be depends on its yaw, too: see [`pitch_range`](crate::head::pitch_range).

use crate::bounds::clamp;
use crate::joints::{Joint, Joints};

/// What a joint's angle may be, ends included: rad; a hand: 0 (closed) to 1 (open).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Least.
    pub min: f32,
    /// Most.
    pub max: f32,
}

impl Range {
    const fn degrees(min: f32, max: f32) -> Self {
        Self { min: min.to_radians(), max: max.to_radians() }
    }

    /// The value of the range nearest to `angle`; what is no number counts as 0.
    #[must_use]
    pub fn clamp(&self, angle: f32) -> f32 {
        clamp(if angle.is_nan() { 0.0 } else { angle }, self.min, self.max)
    }

    /// Whether `angle` lies in the range.
    #[must_use]
    pub fn contains(&self, angle: f32) -> bool {
        (self.min..=self.max).contains(&angle)
    }
}

/// The range of a joint, whatever the others do.
#[must_use]
pub const fn limit(joint: Joint) -> Range {
    match joint {
        Joint::HeadPitch => Range::degrees(-38.5, 29.5),
        Joint::HeadYaw | Joint::LShoulderPitch | Joint::RShoulderPitch | Joint::LElbowYaw | Joint::RElbowYaw => {
            Range::degrees(-119.5, 119.5)
        }
        Joint::LShoulderRoll => Range::degrees(-18.0, 76.0),
        Joint::RShoulderRoll => Range::degrees(-76.0, 18.0),
        Joint::LElbowRoll => Range::degrees(-88.5, -2.0),
        Joint::RElbowRoll => Range::degrees(2.0, 88.5),
        Joint::LWristYaw | Joint::RWristYaw => Range::degrees(-104.5, 104.5),
        Joint::LHand | Joint::RHand => Range { min: 0.0, max: 1.0 },
        Joint::LHipYawPitch => Range::degrees(-65.62, 42.44),
        Joint::LHipRoll => Range::degrees(-21.74, 45.29),
        Joint::RHipRoll => Range::degrees(-45.29, 21.74),
        Joint::LHipPitch | Joint::RHipPitch => Range::degrees(-88.0, 27.73),
        Joint::LKneePitch => Range::degrees(-5.29, 121.04),
        Joint::RKneePitch => Range::degrees(-5.90, 121.47),
        Joint::LAnklePitch => Range::degrees(-68.15, 52.86),
        Joint::RAnklePitch => Range::degrees(-67.97, 53.40),
        Joint::LAnkleRoll => Range::degrees(-22.79, 44.06),
        Joint::RAnkleRoll => Range::degrees(-44.06, 22.80),
    }
}

impl Joints<f32> {
    /// Every joint brought into its [`limit`].
    #[must_use]
    pub fn clamp_to_limits(&self) -> Self {
        let mut clamped = *self;
        for joint in Joint::ALL {
            clamped[joint] = limit(joint).clamp(self[joint]);
        }
        clamped
    }

    /// Whether every joint is within its [`limit`].
    #[must_use]
    pub fn within_limits(&self) -> bool {
        Joint::ALL.into_iter().all(|joint| limit(joint).contains(self[joint]))
    }
}
