//! Postures and stiffness.

use crate::joints::Joints;
use crate::keyframes::Keyframe;
use crate::model::{FallPostures, LimbStiffness, StiffnessTable, symmetric};

/// Stand of the quasi-static walk, hips 0.215 m over the ground. It equals the stand of that gait except for rounding.
pub(super) const STAND: Joints =
    symmetric(0.0, [90.0, 6.990_085, 0.0, -5.729_578, 0.0], [0.0, 0.0, -29.457_882, 65.937_874, -36.479_992, 0.0]);

/// Deep crouch on flat feet.
pub(super) const SIT: Joints = symmetric(0.0, [80.0, 12.0, 0.0, -30.0, 0.0], [0.0, 0.0, -52.0, 119.5, -67.5, 0.0]);

/// To the stand in 1 s.
pub(super) const TO_STAND: [Keyframe; 1] = [Keyframe { seconds: 1.0, posture: STAND, stiffness: 0.8 }];

/// To the crouch in 1.5 s.
pub(super) const TO_SIT: [Keyframe; 1] = [Keyframe { seconds: 1.5, posture: SIT, stiffness: 0.8 }];

/// Postures for a fall: knees 110°, head −33° or +25°. Angles after HULKs 2025.
pub(super) const FALL_POSTURES: FallPostures = FallPostures { front: fall(-33.0), other: fall(25.0) };

const fn fall(head_pitch: f32) -> Keyframe {
    let posture = symmetric(head_pitch, [90.0, 20.0, 0.0, -45.0, 0.0], [0.0, 0.0, -50.0, 110.0, -60.0, 0.0]);
    Keyframe { seconds: 0.4, posture, stiffness: 0.3 }
}

/// Stiffness of the limbs. Sources: B-Human 2023 `stiffnessSettings.cfg`; for a fall, HULKs 2025.
pub(super) const STIFFNESS: StiffnessTable = StiffnessTable {
    stand: LimbStiffness { leg: 0.75, ..WALK },
    walk: WALK,
    fall: LimbStiffness { head: 0.2, shoulder_pitch: 0.05, shoulder_roll: 0.05, elbow: 0.05, wrist: 0.05, leg: 0.2 },
};

const WALK: LimbStiffness =
    LimbStiffness { head: 0.7, shoulder_pitch: 0.1, shoulder_roll: 0.2, elbow: 0.1, wrist: 0.6, leg: 1.0 };
