//! Ranges and speeds of the joints.

use crate::joints::{Joint, Joints};
use crate::model::{HeadPitchLimit, Range};

/// Range of each joint. Sources: B-Human 2023 `jointLimits.cfg` and rUNSWift 2019 `bodyV6.hpp`, which agree.
pub(super) const LIMITS: Joints<Range> = {
    let mut limits = [Range::degrees(-119.5, 119.5); crate::joints::JOINTS];
    let mut i = 0;
    while i < crate::joints::JOINTS {
        limits[i] = limit(Joint::ALL[i]);
        i += 1;
    }
    Joints(limits)
};

const fn limit(joint: Joint) -> Range {
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

/// Maximum speed of each joint, rad/s; a hand: 1/s.
///
/// The lower of two published values: no-load speed divided by gear ratio (rUNSWift 2019 `bodyV6.cpp`), and the velocity
/// limit of Aldebaran's model (HULKs 2025 `NAO.urdf`).
pub(super) const MAX_SPEEDS: Joints = {
    let mut speeds = [0.0; crate::joints::JOINTS];
    let mut i = 0;
    while i < crate::joints::JOINTS {
        speeds[i] = max_speed(Joint::ALL[i]);
        i += 1;
    }
    Joints(speeds)
};

const fn max_speed(joint: Joint) -> f32 {
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

/// Pitch range of the head: its shell would hit the shoulders. Sources: Aldebaran's joints page, B-Human 2023 `headLimits.cfg`.
pub(super) const HEAD_PITCH_LIMITS: [HeadPitchLimit; 7] = [
    HeadPitchLimit::degrees(0.0, -38.50, 29.50),
    HeadPitchLimit::degrees(27.85, -38.50, 24.18),
    HeadPitchLimit::degrees(43.32, -31.40, 21.20),
    HeadPitchLimit::degrees(51.74, -27.50, 18.91),
    HeadPitchLimit::degrees(62.45, -24.64, 17.19),
    HeadPitchLimit::degrees(87.49, -18.91, 11.46),
    HeadPitchLimit::degrees(119.52, -25.73, 18.91),
];
