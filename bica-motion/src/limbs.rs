//! What arms and legs do while the head goes its own way.

use crate::joints::Joints;
use crate::kinematics::LegAngles;
use crate::side::Side;

/// The angles of one arm, rad, and its hand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ArmAngles {
    /// 0 forward, π/2 down.
    pub shoulder_pitch: f32,
    /// Positive to the left.
    pub shoulder_roll: f32,
    /// About the upper arm.
    pub elbow_yaw: f32,
    /// Bends the elbow: negative on the left, positive on the right.
    pub elbow_roll: f32,
    /// About the lower arm.
    pub wrist_yaw: f32,
    /// 0 closed, 1 open.
    pub hand: f32,
}

impl ArmAngles {
    /// Writes the six values to a side's joints.
    pub fn write(&self, side: Side, angles: &mut Joints) {
        let values =
            [self.shoulder_pitch, self.shoulder_roll, self.elbow_yaw, self.elbow_roll, self.wrist_yaw, self.hand];
        for (joint, value) in side.arm().into_iter().zip(values) {
            angles[joint] = value;
        }
    }

    /// An arm that hangs down, a little off the body: `pitch` rad from hanging straight, positive swings it back;
    /// `out` rad off the body.
    #[must_use]
    pub fn hanging(side: Side, pitch: f32, out: f32) -> Self {
        Self {
            shoulder_pitch: core::f32::consts::FRAC_PI_2 + pitch,
            shoulder_roll: side.sign() * out,
            elbow_roll: -side.sign() * 0.1,
            ..Self::default()
        }
    }
}

/// Targets for both legs and both arms, left first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limbs {
    /// Legs; both have the same hip yaw-pitch.
    pub legs: [LegAngles; 2],
    /// Arms.
    pub arms: [ArmAngles; 2],
}

impl Limbs {
    /// Writes all but the head's joints.
    pub fn write(&self, angles: &mut Joints) {
        for side in Side::BOTH {
            self.legs[side.index()].write(side, angles);
            self.arms[side.index()].write(side, angles);
        }
    }

    /// These targets with the head straight ahead.
    #[must_use]
    pub fn joints(&self) -> Joints {
        let mut angles = Joints::all(0.0);
        self.write(&mut angles);
        angles
    }
}
