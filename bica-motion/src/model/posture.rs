//! Symmetric postures.

use crate::joints::Joints;
use crate::keyframes::Keyframe;

/// A posture that is the same on both sides, from the angles of the left side in degrees.
///
/// `arm`: shoulder pitch and roll, elbow yaw and roll, wrist yaw. `leg`: hip yaw-pitch, roll and pitch, knee pitch, ankle
/// pitch and roll. The hands are closed; `head_pitch` is positive down.
#[must_use]
pub const fn symmetric(head_pitch: f32, arm: [f32; 5], leg: [f32; 6]) -> Joints {
    let a = [arm[0].to_radians(), arm[1].to_radians(), arm[2].to_radians(), arm[3].to_radians(), arm[4].to_radians()];
    let l = [
        leg[0].to_radians(),
        leg[1].to_radians(),
        leg[2].to_radians(),
        leg[3].to_radians(),
        leg[4].to_radians(),
        leg[5].to_radians(),
    ];
    Joints([
        0.0,
        head_pitch.to_radians(),
        a[0],
        a[1],
        a[2],
        a[3],
        a[4],
        l[0],
        l[1],
        l[2],
        l[3],
        l[4],
        l[5],
        -l[1],
        l[2],
        l[3],
        l[4],
        -l[5],
        a[0],
        -a[1],
        -a[2],
        -a[3],
        -a[4],
        0.0,
        0.0,
    ])
}

/// Postures for a fall: arms and legs drawn in, the head away from the ground, with little stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FallPostures {
    /// For a fall to the front.
    pub front: Keyframe,
    /// For a fall to the back or to a side.
    pub other: Keyframe,
}
