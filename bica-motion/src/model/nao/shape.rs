//! Outer shape. Radii are our estimate.

use super::dimensions::DIMENSIONS;
use crate::model::{BodyShape, Capsule};

/// Capsules of trunk and limbs.
pub(super) const BODY_SHAPE: BodyShape = BodyShape {
    torso: [
        Capsule { from: [0.0, 0.0, 0.05], to: [0.002, 0.0, 0.14], radius: 0.052 },
        Capsule { from: [0.002, 0.045, 0.13], to: [0.002, -0.045, 0.13], radius: 0.052 },
    ],
    biceps: [
        Capsule { from: [0.0; 3], to: [0.02, 0.0, 0.0], radius: 0.042 },
        Capsule { from: [0.02, 0.0, 0.0], to: [DIMENSIONS.upper_arm.x, DIMENSIONS.upper_arm.y, 0.0], radius: 0.034 },
    ],
    forearm: Capsule { from: [0.0; 3], to: [0.11, 0.0, 0.0], radius: 0.032 },
    thigh: Capsule { from: [0.0; 3], to: [0.0, 0.0, -DIMENSIONS.thigh], radius: 0.048 },
    tibia: Capsule { from: [0.0; 3], to: [0.0, 0.0, -DIMENSIONS.tibia], radius: 0.042 },
    foot: [foot(-0.018), foot(0.018)],
};

/// Half of the foot, `lateral` m from its centre line.
const fn foot(lateral: f32) -> Capsule {
    let (y, z) = (0.0065 + lateral, 0.025 - DIMENSIONS.foot_height);
    Capsule { from: [-0.03, y, z], to: [0.072, y, z], radius: 0.028 }
}
