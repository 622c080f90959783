//! Key postures of getting up.

use crate::joints::{JOINTS, Joint, Joints};
use crate::model::RobotModel;

/// Number of joints in a frame: all but the hands, which stay closed.
const FRAME_JOINTS: usize = JOINTS - 2;

/// A posture in few bytes, and the time to reach it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GetUpFrame {
    centiseconds: u8,
    degrees: [i8; FRAME_JOINTS],
}

impl GetUpFrame {
    /// A frame from its duration in units of 10 ms, and the angles in whole degrees in the order of the joints.
    #[must_use]
    pub const fn new(centiseconds: u8, degrees: [i8; FRAME_JOINTS]) -> Self {
        Self { centiseconds, degrees }
    }

    /// A frame whose right side mirrors the left one, for legs with a hip yaw of their own: the left arm (shoulder pitch and roll,
    /// elbow yaw and roll), and the left leg (hip yaw, roll and pitch, knee, ankle pitch and roll). The others are 0.
    #[must_use]
    pub const fn symmetric(centiseconds: u8, arm: [i8; 4], leg: [i8; 6]) -> Self {
        let ([pitch, roll, elbow_yaw, elbow], [yaw, hip_roll, hip, knee, ankle, ankle_roll]) = (arm, leg);
        let left = [pitch, roll, elbow_yaw, elbow, 0, yaw, hip_roll, hip, knee, ankle, ankle_roll];
        let right = [-hip_roll, hip, knee, ankle, -ankle_roll, pitch, -roll, -elbow_yaw, -elbow];
        let mut degrees = [0; FRAME_JOINTS];
        let mut i = 0;
        while i < left.len() {
            degrees[2 + i] = left[i];
            i += 1;
        }
        i = 0;
        while i < right.len() {
            degrees[2 + left.len() + i] = right[i];
            i += 1;
        }
        Self::new(centiseconds, degrees)
    }

    /// Duration of the motion to the posture, s.
    #[must_use]
    pub fn seconds(&self) -> f32 {
        f32::from(self.centiseconds) / 100.0
    }

    /// Joint angles at the end, rad, or their mirror image. A robot with two hip yaws moves them symmetrically, keeps its waist
    /// straight and stays within its limits: similar robots share frames.
    #[must_use]
    pub fn posture(&self, model: &RobotModel, mirrored: bool) -> Joints {
        let mut posture = Joints::all(0.0);
        for (angle, degrees) in posture.0.iter_mut().zip(self.degrees) {
            *angle = f32::from(degrees).to_radians();
        }
        if mirrored {
            posture = posture.mirrored();
        }
        if !model.leg.shares_hip_yaw() {
            posture[Joint::RIGHT_HIP_YAW] = -posture[Joint::LEFT_HIP_YAW];
            posture = posture.clamp_to_limits(model);
        }
        posture
    }
}

/// Key postures of getting up and of turning over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GetUpFrames {
    /// From lying on the front to sitting.
    pub sit_up_from_front: &'static [GetUpFrame],
    /// From lying on the back to sitting.
    pub sit_up_from_back: &'static [GetUpFrame],
    /// From lying on the right side to sitting, and mirrored from the left side; if empty, the way from the back serves.
    pub sit_up_from_side: &'static [GetUpFrame],
    /// From sitting to a deep crouch. The stand follows.
    pub rise: &'static [GetUpFrame],
    /// From lying on the front to lying on the back.
    pub turn_from_front: &'static [GetUpFrame],
    /// From lying on the back to lying on the front.
    pub turn_from_back: &'static [GetUpFrame],
    /// Index of the frame of `sit_up_from_back` from which a robot that lay on its side lies on its back.
    pub rolled_onto_back: usize,
}
