//! What a calibration estimates.

use bica_motion::joints::Joints;
use bica_motion::kinematics;
use bica_motion::model::NAO;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use bica_vision::projection::{Camera, Intrinsics, Mounting};
use glam::{Affine3A, Quat};
use nalgebra::SVector;

/// Number of estimated angles.
pub(super) const ANGLES: usize = 8;

/// Estimated angles, rad: roll, tilt and pan of the top camera, of the bottom one, then roll and pitch of the body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Offsets(pub(super) SVector<f32, ANGLES>);

impl Offsets {
    /// Offsets of known angles, rad.
    #[must_use]
    pub fn new(top: [f32; 3], bottom: [f32; 3], body: [f32; 2]) -> Self {
        let angles = top.into_iter().chain(bottom).chain(body);
        Self(SVector::from_iterator(angles))
    }

    /// Correction of the mounting of a camera.
    #[must_use]
    pub fn mounting(&self, camera: CameraId) -> Mounting {
        let first = 3 * camera as usize;
        Mounting { roll: self.0[first], tilt: self.0[first + 1], pan: self.0[first + 2], focal_scale: 1.0 }
    }

    /// Lean of the body about the middle of its hips, beyond that of the measured angles, rad: to its right, and forwards.
    #[must_use]
    pub fn body(&self) -> [f32; 2] {
        [self.0[6], self.0[7]]
    }

    /// Camera of a standing NAO with these offsets, for images of a size, px, at the measured joint angles.
    #[must_use]
    pub fn camera(&self, camera: CameraId, angles: &Joints, (width, height): (u16, u16)) -> Camera {
        let [roll, pitch] = self.body();
        let lean = Affine3A::from_quat(Quat::from_rotation_y(pitch) * Quat::from_rotation_x(roll));
        let robot = kinematics::ground_from_robot(NAO, Side::Left, angles) * lean;
        let pose = robot * kinematics::camera(NAO, camera, angles);
        Camera::new(pose, Intrinsics::of(NAO, camera, width, height)).corrected(&self.mounting(camera))
    }
}
