//! Key postures of getting up.

use crate::joints::{JOINTS, Joints};

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

    /// Duration of the motion to the posture, s.
    #[must_use]
    pub fn seconds(&self) -> f32 {
        f32::from(self.centiseconds) / 100.0
    }

    /// Joint angles at the end, rad.
    #[must_use]
    pub fn posture(&self) -> Joints {
        let mut posture = Joints::all(0.0);
        for (angle, degrees) in posture.0.iter_mut().zip(self.degrees) {
            *angle = f32::from(degrees).to_radians();
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
    /// From sitting to a deep crouch. The stand follows.
    pub rise: &'static [GetUpFrame],
    /// From lying on the front to lying on the back.
    pub turn_from_front: &'static [GetUpFrame],
    /// From lying on the back to lying on the front.
    pub turn_from_back: &'static [GetUpFrame],
    /// Index of the frame of `sit_up_from_back` from which a robot that lay on its side lies on its back.
    pub rolled_onto_back: usize,
}
