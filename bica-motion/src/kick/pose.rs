//! Leg angles of a kick's poses.

use glam::{Affine3A, Vec3};

use crate::easing::mix;
use crate::kinematics::{YawFrom, legs_angles};
use crate::limbs::LegAngles;
use crate::model::{KickPose, Parameters, RobotModel};
use crate::side::Side;

impl KickPose {
    /// Stand of a gait, before and after the kick.
    pub(super) const fn stand(gait: &Parameters) -> Self {
        Self {
            hips: Vec3::new(gait.torso_offset, 0.0, gait.hip_height),
            foot: Vec3::new(0.0, gait.half_spacing, 0.0),
            yaw: 0.0,
            roll: 0.0,
            pitch: 0.0,
        }
    }

    /// Linear interpolation from this pose to another.
    pub(super) fn mix(&self, to: &Self, share: f32) -> Self {
        Self {
            hips: self.hips.lerp(to.hips, share),
            foot: self.foot.lerp(to.foot, share),
            yaw: mix(self.yaw, to.yaw, share),
            roll: mix(self.roll, to.roll, share),
            pitch: mix(self.pitch, to.pitch, share),
        }
    }

    /// Leg angles, left first, of this pose with the given kicking foot.
    #[must_use]
    pub fn legs(&self, model: &RobotModel, kicking: Side, gait: &Parameters) -> [LegAngles; 2] {
        let side = kicking.sign();
        let on = |place: Vec3| Vec3::new(place.x, side * place.y, place.z);
        let torso = at(on(self.hips)) * Affine3A::from_rotation_z(0.5 * side * self.yaw);
        let up = at(Vec3::new(0.0, 0.0, model.dimensions.foot_height));
        let turn = Affine3A::from_rotation_z(side * self.yaw)
            * Affine3A::from_rotation_y(self.pitch)
            * Affine3A::from_rotation_x(side * self.roll);
        let kicks = at(on(self.foot)) * turn * up;
        let supports = at(Vec3::new(0.0, -side * gait.half_spacing, 0.0)) * up;
        let seen = torso.inverse();
        let (left, right) = if kicking == Side::Left { (kicks, supports) } else { (supports, kicks) };
        legs_angles(model, &(seen * left), &(seen * right), YawFrom::Leg(kicking.other()))
    }
}

fn at(place: Vec3) -> Affine3A {
    Affine3A::from_translation(place)
}
