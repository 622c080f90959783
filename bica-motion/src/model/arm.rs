//! Kinematics of arms that point to the sides at zero.

use glam::{Affine3A, Vec3};

use crate::side::Side;

/// Direction of the arms at zero joint angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ArmGeometry {
    /// Ahead; shoulder roll and elbow roll turn about z, elbow yaw about x.
    Forward,
    /// To the sides; shoulder roll turns about x, elbow yaw about y, elbow roll about z. There is no wrist.
    Sideways(SidewaysArm),
}

/// Offsets between the joints of the left arm, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SidewaysArm {
    /// Shoulder pitch to shoulder roll.
    pub biceps: Vec3,
    /// Shoulder roll to elbow yaw.
    pub elbow: Vec3,
    /// Elbow yaw to elbow roll.
    pub forearm: Vec3,
}

impl SidewaysArm {
    /// Poses of shoulder, biceps, elbow, forearm and hand, which is part of the forearm.
    pub(crate) fn poses(&self, side: Side, shoulder: Vec3, [pitch, roll, yaw, bend, ..]: [f32; 6]) -> [Affine3A; 5] {
        let at = |left: Vec3| Affine3A::from_translation(Vec3::new(left.x, side.sign() * left.y, left.z));
        let shoulder = Affine3A::from_translation(shoulder) * Affine3A::from_rotation_y(pitch);
        let biceps = shoulder * at(self.biceps) * Affine3A::from_rotation_x(roll);
        let elbow = biceps * at(self.elbow) * Affine3A::from_rotation_y(yaw);
        let forearm = elbow * at(self.forearm) * Affine3A::from_rotation_z(bend);
        [shoulder, biceps, elbow, forearm, forearm]
    }
}
