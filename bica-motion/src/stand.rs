//! Postures to be in, and how hard to hold them.

use crate::joints::{Joint, Joints};
use crate::keyframes::Keyframe;

/// A posture that is the same on both sides, from its left side's angles in degrees.
///
/// `arm`: shoulder pitch and roll, elbow yaw and roll, wrist yaw. `leg`: hip yaw-pitch, roll and pitch, knee pitch, ankle
/// pitch and roll. Hands are closed, `head_pitch` is positive down.
pub(crate) const fn symmetric(head_pitch: f32, arm: [f32; 5], leg: [f32; 6]) -> Joints {
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

/// The stand that the walk starts from and ends in, hips 0.215 m over the ground; the same as
/// [`Parameters::BUILT_IN.stand()`](crate::walk::Parameters::stand) but for rounding.
pub const STAND: Joints =
    symmetric(0.0, [90.0, 6.990_085, 0.0, -5.729_578, 0.0], [0.0, 0.0, -29.457_882, 65.937_874, -36.479_992, 0.0]);

/// A deep crouch on flat feet that needs next to no force: to sit down in, and to get up from.
pub const SIT: Joints = symmetric(0.0, [80.0, 12.0, 0.0, -30.0, 0.0], [0.0, 0.0, -52.0, 119.5, -67.5, 0.0]);

/// From anywhere to [`STAND`] in a second.
pub const TO_STAND: [Keyframe; 1] = [Keyframe { seconds: 1.0, posture: STAND, stiffness: 0.8 }];

/// From a stand to [`SIT`] in 1.5 s.
pub const TO_SIT: [Keyframe; 1] = [Keyframe { seconds: 1.5, posture: SIT, stiffness: 0.8 }];

/// How hard to hold [`SIT`] for good, 0 to 1: the least that does not tip over in `MuJoCo`, where it takes a fifteenth of what
/// the motors bear.
pub const SIT_STIFFNESS: f32 = 0.1;

/// How hard the joints are held.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stiffness {
    /// Not at all.
    Limp,
    /// To stand: legs 0.75.
    Stand,
    /// To walk or kick: legs 1.
    Walk,
    /// To fall softly.
    Fall,
}

impl Stiffness {
    /// The stiffness of every joint, 0 to 1. Sources: B-Human 2023 `stiffnessSettings.cfg`; to fall, HULKs 2025.
    #[must_use]
    pub fn joints(self) -> Joints {
        let (head, [shoulder_pitch, shoulder_roll, elbow, wrist], leg) = match self {
            Self::Limp => return Joints::all(0.0),
            Self::Stand => (0.7, [0.1, 0.2, 0.1, 0.6], 0.75),
            Self::Walk => (0.7, [0.1, 0.2, 0.1, 0.6], 1.0),
            Self::Fall => (0.2, [0.05; 4], 0.2),
        };
        let mut stiffness = Joints::all(0.0);
        for joint in Joint::ALL {
            use Joint::{
                HeadPitch, HeadYaw, LElbowRoll, LElbowYaw, LHand, LShoulderPitch, LShoulderRoll, LWristYaw, RElbowRoll,
                RElbowYaw, RHand, RShoulderPitch, RShoulderRoll, RWristYaw,
            };
            stiffness[joint] = match joint {
                HeadYaw | HeadPitch => head,
                LShoulderPitch | RShoulderPitch => shoulder_pitch,
                LShoulderRoll | RShoulderRoll => shoulder_roll,
                LElbowYaw | LElbowRoll | RElbowYaw | RElbowRoll => elbow,
                LWristYaw | RWristYaw => wrist,
                LHand | RHand => 0.0,
                _ => leg,
            };
        }
        stiffness
    }
}
