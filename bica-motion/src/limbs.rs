//! Angles of legs and arms, without the head.

use core::f32::consts::FRAC_PI_2;

use crate::joints::{Joint, Joints};
use crate::model::{ArmGeometry, RobotModel};
use crate::side::Side;

/// Angles of one leg, rad.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LegAngles {
    /// The joint that both legs share; negative turns the toes out. With two hip yaws: this leg's; positive turns left.
    pub hip_yaw_pitch: f32,
    /// Positive swings the leg to the left.
    pub hip_roll: f32,
    /// Negative swings the leg forward.
    pub hip_pitch: f32,
    /// Positive bends the knee.
    pub knee_pitch: f32,
    /// Positive presses the toes down.
    pub ankle_pitch: f32,
    /// Positive presses the foot's right edge down.
    pub ankle_roll: f32,
}

impl LegAngles {
    /// Writes the six angles to a side's joints; a shared yaw-pitch goes to the joint that both sides share.
    pub fn write(&self, model: &RobotModel, side: Side, angles: &mut Joints) {
        let values =
            [self.hip_yaw_pitch, self.hip_roll, self.hip_pitch, self.knee_pitch, self.ankle_pitch, self.ankle_roll];
        for (joint, value) in model.leg_joints(side).into_iter().zip(values) {
            angles[joint] = value;
        }
    }

    /// Moves each angle on toward its `later` value, by these shares of the difference.
    pub(crate) fn lead(&mut self, later: &Self, [yaw, roll, pitch, knee, ankle_pitch, ankle_roll]: &[f32; 6]) {
        self.hip_yaw_pitch += yaw * (later.hip_yaw_pitch - self.hip_yaw_pitch);
        self.hip_roll += roll * (later.hip_roll - self.hip_roll);
        self.hip_pitch += pitch * (later.hip_pitch - self.hip_pitch);
        self.knee_pitch += knee * (later.knee_pitch - self.knee_pitch);
        self.ankle_pitch += ankle_pitch * (later.ankle_pitch - self.ankle_pitch);
        self.ankle_roll += ankle_roll * (later.ankle_roll - self.ankle_roll);
    }

    /// Reads a side's six angles.
    #[must_use]
    pub fn read(model: &RobotModel, side: Side, angles: &Joints) -> Self {
        let [hip_yaw_pitch, hip_roll, hip_pitch, knee_pitch, ankle_pitch, ankle_roll] =
            model.leg_joints(side).map(|joint: Joint| angles[joint]);
        Self { hip_yaw_pitch, hip_roll, hip_pitch, knee_pitch, ankle_pitch, ankle_roll }
    }
}

/// Angles of one arm, rad, and its hand.
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

    /// A hanging arm: `pitch` rad from straight down, positive to the back; `out` rad away from the body.
    #[must_use]
    pub fn hanging(model: &RobotModel, side: Side, pitch: f32, out: f32) -> Self {
        let (forward, down) = match model.arm {
            ArmGeometry::Forward => (FRAC_PI_2, 0.0),
            ArmGeometry::Sideways(_) => (0.0, -FRAC_PI_2),
        };
        Self {
            shoulder_pitch: forward + pitch,
            shoulder_roll: side.sign() * (down + out),
            elbow_roll: -side.sign() * 0.1,
            ..Self::default()
        }
    }
}

/// Target angles of both legs and both arms, left first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limbs {
    /// Legs; both have the same hip yaw-pitch.
    pub legs: [LegAngles; 2],
    /// Arms.
    pub arms: [ArmAngles; 2],
}

impl Limbs {
    /// Writes all joints except the head's.
    pub fn write(&self, model: &RobotModel, angles: &mut Joints) {
        for side in Side::BOTH {
            // Legs last: joints of a robot without fingers may have the places of the hands.
            self.arms[side.index()].write(side, angles);
        }
        for side in Side::BOTH {
            self.legs[side.index()].write(model, side, angles);
        }
    }

    /// Leans the torso forward by `angle` rad over unchanged feet.
    pub fn lean(&mut self, angle: f32) {
        for leg in &mut self.legs {
            leg.hip_pitch -= angle;
        }
    }

    /// All joints, with the head straight ahead.
    #[must_use]
    pub fn joints(&self, model: &RobotModel) -> Joints {
        let mut angles = Joints::all(0.0);
        self.write(model, &mut angles);
        angles
    }
}
