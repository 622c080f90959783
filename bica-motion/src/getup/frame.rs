//! Postures in few bytes.

use crate::joints::{JOINTS, Joints};

/// Joints that a frame places: all but the hands, which stay closed.
const PLACED: usize = JOINTS - 2;

/// A posture to reach, and how long the way there takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Frame {
    hundredths: u8,
    degrees: [i8; PLACED],
}

impl Frame {
    /// `hundredths` of a second; angles in the order of the joints, whole degrees.
    pub(super) const fn new(hundredths: u8, degrees: [i8; PLACED]) -> Self {
        Self { hundredths, degrees }
    }

    /// How long the way there takes, s.
    pub(super) fn seconds(&self) -> f32 {
        f32::from(self.hundredths) / 100.0
    }

    /// The angles, rad.
    pub(super) fn posture(&self) -> Joints {
        let mut posture = Joints::all(0.0);
        for (angle, degrees) in posture.0.iter_mut().zip(self.degrees) {
            *angle = f32::from(degrees).to_radians();
        }
        posture
    }
}
