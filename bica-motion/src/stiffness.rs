//! Stiffness of the joints in each kind of motion.

use crate::joints::{Joint, Joints};
use crate::model::RobotModel;

/// Kind of motion that determines the stiffness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stiffness {
    /// No stiffness.
    Limp,
    /// Standing.
    Stand,
    /// Walking and kicking.
    Walk,
    /// Falling.
    Fall,
}

impl Stiffness {
    /// Stiffness of every joint, 0 to 1, from [`RobotModel::stiffness`].
    #[must_use]
    pub fn joints(self, model: &RobotModel) -> Joints {
        let limbs = match self {
            Self::Limp => return Joints::all(0.0),
            Self::Stand => model.stiffness.stand,
            Self::Walk => model.stiffness.walk,
            Self::Fall => model.stiffness.fall,
        };
        let mut stiffness = Joints::all(0.0);
        for joint in Joint::ALL {
            use Joint::{
                HeadPitch, HeadYaw, LElbowRoll, LElbowYaw, LHand, LShoulderPitch, LShoulderRoll, LWristYaw, RElbowRoll,
                RElbowYaw, RHand, RShoulderPitch, RShoulderRoll, RWristYaw,
            };
            stiffness[joint] = match joint {
                HeadYaw | HeadPitch => limbs.head,
                LShoulderPitch | RShoulderPitch => limbs.shoulder_pitch,
                LShoulderRoll | RShoulderRoll => limbs.shoulder_roll,
                LElbowYaw | LElbowRoll | RElbowYaw | RElbowRoll => limbs.elbow,
                LWristYaw | RWristYaw => limbs.wrist,
                LHand | RHand if model.leg.shares_hip_yaw() => 0.0,
                _ => limbs.leg,
            };
        }
        stiffness
    }
}
