//! How fast each joint turns.

use crate::bounds::clamp;
use crate::joints::{Joint, Joints};

/// From a command to the first motion of a joint, s. Source: B-Human 2015.
pub const DEAD_TIME: f32 = 0.03;

/// The most that a joint turns in a second, rad/s; a hand: 1/s.
///
/// The lower of two published values: the motor's no-load speed over its gear (rUNSWift 2019 `bodyV6.cpp`) and the
/// velocity limit of Aldebaran's model (HULKs 2025 `NAO.urdf`).
#[must_use]
pub const fn max_speed(joint: Joint) -> f32 {
    match joint {
        Joint::HeadYaw | Joint::LElbowYaw | Joint::RElbowYaw => 7.46,
        Joint::HeadPitch | Joint::LShoulderRoll | Joint::RShoulderRoll | Joint::LElbowRoll | Joint::RElbowRoll => 6.47,
        Joint::LShoulderPitch | Joint::RShoulderPitch => 7.94,
        Joint::LWristYaw | Joint::RWristYaw => 17.38,
        Joint::LHand | Joint::RHand => 8.33,
        Joint::LHipYawPitch | Joint::LHipRoll | Joint::RHipRoll | Joint::LAnkleRoll | Joint::RAnkleRoll => 4.162,
        Joint::LHipPitch
        | Joint::RHipPitch
        | Joint::LKneePitch
        | Joint::RKneePitch
        | Joint::LAnklePitch
        | Joint::RAnklePitch => 6.402,
    }
}

impl Joints<f32> {
    /// From these angles toward `targets`, each joint as far as its [`max_speed`] allows in `dt` seconds.
    ///
    /// A target that is no number leaves its joint where it is; so does a `dt` that is negative or no number.
    #[must_use]
    pub fn moved_toward(&self, targets: &Self, dt: f32) -> Self {
        let mut moved = *self;
        for joint in Joint::ALL {
            let most = max_speed(joint) * dt;
            let way = targets[joint] - self[joint];
            if most > 0.0 && !way.is_nan() {
                moved[joint] += clamp(way, -most, most);
            }
        }
        moved
    }
}
