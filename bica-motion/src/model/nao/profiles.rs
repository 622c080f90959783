//! Tuned motions.

use glam::Vec2;

use super::{gait, kick_dynamic, kick_kinematic};
use crate::model::{Calibration, Kicks, Profile, Technique};

/// Motions for a world without dynamics. In the kicks no joint exceeds its maximum speed.
pub(super) const KINEMATIC: Profile = Profile {
    gait: gait::KINEMATIC,
    kicks: Kicks {
        front: Technique { ball: Vec2::new(0.170, 0.060), frames: &kick_kinematic::FRONT },
        diagonal: Technique { ball: Vec2::new(0.155, -0.014), frames: &kick_kinematic::DIAGONAL },
        lateral: Technique { ball: Vec2::new(0.155, 0.002), frames: &kick_kinematic::LATERAL },
    },
    odometry: Calibration::EXACT,
};

/// Motions for a world with dynamics.
///
/// The odometry scale for commanded displacements was measured in trials in `MuJoCo`. It is above 1 because the gait plans
/// less than requested ([`Parameters::velocity_scale`](crate::model::Parameters::velocity_scale)). In 12 games and 32 falls in `MuJoCo` no
/// turn by more than 0.04 rad/s beyond the slip lasted; the limit is wider, because a real robot on grass was not measured.
pub(super) const DYNAMIC: Profile = Profile {
    gait: gait::DYNAMIC,
    kicks: Kicks {
        front: Technique { ball: Vec2::new(0.170, 0.060), frames: &kick_dynamic::FRONT },
        diagonal: Technique { ball: Vec2::new(0.158, -0.025), frames: &kick_dynamic::DIAGONAL },
        lateral: Technique { ball: Vec2::new(0.156, -0.002), frames: &kick_dynamic::LATERAL },
    },
    odometry: Calibration { commanded_scale: Vec2::new(1.14, 1.05), max_turn_difference: 0.06, ..Calibration::EXACT },
};
