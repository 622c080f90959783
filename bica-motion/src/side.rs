//! Sides of the body, and mirror images of postures.

use crate::joints::{Joint, Joints};

/// A side of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, postcard_schema::Schema)]
pub enum Side {
    /// Positive y.
    Left,
    /// Negative y.
    Right,
}

impl Side {
    /// Both sides, left first.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// The opposite side.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// Sign of y on this side: +1 left, −1 right.
    #[must_use]
    pub const fn sign(self) -> f32 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// Index of the side: 0 left, 1 right.
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Joints of this side's leg from the hip down: hip yaw-pitch (shared by both legs), hip roll, hip pitch, knee pitch,
    /// ankle pitch, ankle roll.
    #[must_use]
    pub const fn leg(self) -> [Joint; 6] {
        use Joint::{
            LAnklePitch, LAnkleRoll, LHipPitch, LHipRoll, LHipYawPitch, LKneePitch, RAnklePitch, RAnkleRoll, RHipPitch,
            RHipRoll, RKneePitch,
        };
        match self {
            Self::Left => [LHipYawPitch, LHipRoll, LHipPitch, LKneePitch, LAnklePitch, LAnkleRoll],
            Self::Right => [LHipYawPitch, RHipRoll, RHipPitch, RKneePitch, RAnklePitch, RAnkleRoll],
        }
    }

    /// Joints of this side's arm from the shoulder out: shoulder pitch, shoulder roll, elbow yaw, elbow roll, wrist yaw, hand.
    #[must_use]
    pub const fn arm(self) -> [Joint; 6] {
        use Joint::{
            LElbowRoll, LElbowYaw, LHand, LShoulderPitch, LShoulderRoll, LWristYaw, RElbowRoll, RElbowYaw, RHand,
            RShoulderPitch, RShoulderRoll, RWristYaw,
        };
        match self {
            Self::Left => [LShoulderPitch, LShoulderRoll, LElbowYaw, LElbowRoll, LWristYaw, LHand],
            Self::Right => [RShoulderPitch, RShoulderRoll, RElbowYaw, RElbowRoll, RWristYaw, RHand],
        }
    }
}

impl Joint {
    /// Mirror image of the joint; head joints and the shared hip yaw-pitch are their own mirror images.
    #[must_use]
    pub fn mirrored(self) -> Self {
        for side in Side::BOTH {
            let pairs = side.leg().into_iter().zip(side.other().leg());
            let pairs = pairs.chain(side.arm().into_iter().zip(side.other().arm()));
            for (from, to) in pairs {
                if from == self {
                    return to;
                }
            }
        }
        self
    }

    /// Whether the mirror image of the joint has the opposite angle: true for rolls and yaws, false for pitches, the shared
    /// hip yaw-pitch and the hands.
    #[must_use]
    pub const fn changes_sign_mirrored(self) -> bool {
        use Joint::{
            HeadYaw, LAnkleRoll, LElbowRoll, LElbowYaw, LHipRoll, LShoulderRoll, LWristYaw, RAnkleRoll, RElbowRoll,
            RElbowYaw, RHipRoll, RShoulderRoll, RWristYaw,
        };
        matches!(
            self,
            HeadYaw
                | LShoulderRoll
                | LElbowYaw
                | LElbowRoll
                | LWristYaw
                | LHipRoll
                | LAnkleRoll
                | RShoulderRoll
                | RElbowYaw
                | RElbowRoll
                | RWristYaw
                | RHipRoll
                | RAnkleRoll
        )
    }
}

impl Joints<f32> {
    /// Mirror image of the posture: left and right exchanged.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mut mirrored = *self;
        for joint in Joint::ALL {
            let angle = self[joint];
            mirrored[joint.mirrored()] = if joint.changes_sign_mirrored() { -angle } else { angle };
        }
        mirrored
    }
}
