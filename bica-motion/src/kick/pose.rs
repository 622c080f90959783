//! What the body does at a moment of a kick.

use glam::{Affine3A, Vec3};

use crate::dimensions::FOOT_HEIGHT;
use crate::easing::mix;
use crate::kinematics::{LegAngles, YawFrom, legs_angles};
use crate::side::Side;
use crate::walk::Parameters;

/// The body over the foot that carries it, for a kick with the left foot; with the right one everything is mirrored.
///
/// Frame: on the ground between the feet of the stand before the kick. The right foot stays there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct KickPose {
    /// The middle between the hips, m.
    pub(super) hips: Vec3,
    /// The sole of the kicking foot, under its ankle, m.
    pub(super) foot: Vec3,
    /// The heading of the kicking foot, rad; the torso turns half as far, because both legs share a motor.
    pub(super) yaw: f32,
    /// The roll of the kicking foot, rad: positive lifts its left edge.
    pub(super) roll: f32,
    /// The pitch of the kicking foot, rad: positive lifts its heel.
    pub(super) pitch: f32,
}

/// A pose and how long the way there takes, s.
pub(super) type Frame = (f32, KickPose);

/// A pose to reach in `seconds`, from places in m and angles in rad as in [`KickPose`].
pub(super) const fn frame(seconds: f32, hips: [f32; 3], foot: [f32; 3], [yaw, roll, pitch]: [f32; 3]) -> Frame {
    (seconds, KickPose { hips: Vec3::from_array(hips), foot: Vec3::from_array(foot), yaw, roll, pitch })
}

impl KickPose {
    /// The stand of a gait, before and after.
    pub(super) const fn stand(gait: &Parameters) -> Self {
        Self {
            hips: Vec3::new(gait.torso_offset, 0.0, gait.hip_height),
            foot: Vec3::new(0.0, gait.half_spacing, 0.0),
            yaw: 0.0,
            roll: 0.0,
            pitch: 0.0,
        }
    }

    /// The pose at a share of the way from this one to another.
    pub(super) fn mix(&self, to: &Self, share: f32) -> Self {
        Self {
            hips: self.hips.lerp(to.hips, share),
            foot: self.foot.lerp(to.foot, share),
            yaw: mix(self.yaw, to.yaw, share),
            roll: mix(self.roll, to.roll, share),
            pitch: mix(self.pitch, to.pitch, share),
        }
    }

    /// The leg angles, left first, that make this pose with a foot.
    pub(super) fn legs(&self, kicking: Side, gait: &Parameters) -> [LegAngles; 2] {
        let side = kicking.sign();
        let on = |place: Vec3| Vec3::new(place.x, side * place.y, place.z);
        let torso = at(on(self.hips)) * Affine3A::from_rotation_z(0.5 * side * self.yaw);
        let up = at(Vec3::new(0.0, 0.0, FOOT_HEIGHT));
        let turn = Affine3A::from_rotation_z(side * self.yaw)
            * Affine3A::from_rotation_y(self.pitch)
            * Affine3A::from_rotation_x(side * self.roll);
        let kicks = at(on(self.foot)) * turn * up;
        let carries = at(Vec3::new(0.0, -side * gait.half_spacing, 0.0)) * up;
        let seen = torso.inverse();
        let (left, right) = if kicking == Side::Left { (kicks, carries) } else { (carries, kicks) };
        legs_angles(&(seen * left), &(seen * right), YawFrom::Leg(kicking.other()))
    }
}

fn at(place: Vec3) -> Affine3A {
    Affine3A::from_translation(place)
}
