//! Inverse kinematics of the legs in closed form.
//!
//! Seen from the foot, the distance to the hip gives the knee and its direction gives both ankle angles; the rotation
//! that is left is the hip's. Both legs share one yaw-pitch motor, so a pair of poses generally asks for two values of
//! it: one is chosen and both legs are solved again with it, which keeps the places and the soles' normals and lets only
//! the feet's yaw give way.

use core::f32::consts::FRAC_PI_4;

use glam::{Affine3A, Mat3A, Vec3A};
use libm::{atan2f, cosf, hypotf, sinf, sqrtf};

use crate::dimensions::{HIP, THIGH, TIBIA};
use crate::joints::{Joint, Joints};
use crate::side::Side;

/// The angles of one leg, rad.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LegAngles {
    /// The joint that both legs share; negative turns the toes out.
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
    /// Writes the six angles to a side's joints; the yaw-pitch goes to the joint that both sides share.
    pub fn write(&self, side: Side, angles: &mut Joints) {
        let values =
            [self.hip_yaw_pitch, self.hip_roll, self.hip_pitch, self.knee_pitch, self.ankle_pitch, self.ankle_roll];
        for (joint, value) in side.leg().into_iter().zip(values) {
            angles[joint] = value;
        }
    }

    /// A side's six angles.
    #[must_use]
    pub fn read(side: Side, angles: &Joints) -> Self {
        let [hip_yaw_pitch, hip_roll, hip_pitch, knee_pitch, ankle_pitch, ankle_roll] =
            side.leg().map(|joint: Joint| angles[joint]);
        Self { hip_yaw_pitch, hip_roll, hip_pitch, knee_pitch, ankle_pitch, ankle_roll }
    }
}

/// Which leg's wish the shared hip yaw-pitch follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum YawFrom {
    /// The mean of both wishes: the yaw between the feet stays right.
    Mean,
    /// One leg's wish: that foot's pose is exact.
    Leg(Side),
    /// This angle, rad.
    Angle(f32),
}

/// The angles that bring a foot to a pose, with the yaw-pitch of this leg's own choice.
///
/// `ankle` is the foot's pose in the robot frame with its origin where the ankle's axes meet
/// ([`FOOT_HEIGHT`](crate::dimensions::FOOT_HEIGHT) above the sole). A place out of reach gives the straight (or
/// closest) leg in its direction. Limits are not looked at. The formulas are singular at a
/// hip roll of 45° inwards, twice what the joint reaches, and where the hip lies on the axis of the ankle's roll.
#[must_use]
pub fn leg_angles(side: Side, ankle: &Affine3A) -> LegAngles {
    let hip = hip_of(side);
    let rotation = ankle.matrix3;
    let to_hip = -(rotation.transpose() * (ankle.translation - hip));
    // A crouch can bring the hip under the plane of the foot; the ankle's roll never passes 90° for it.
    let over = if to_hip.z < 0.0 { -1.0 } else { 1.0 };
    let lower = over * hypotf(to_hip.y, to_hip.z);
    let knee_pitch = knee(hypotf(to_hip.x, lower));
    let ankle_roll = atan2f(over * to_hip.y, over * to_hip.z);
    let lean = atan2f(THIGH * sinf(knee_pitch), TIBIA + THIGH * cosf(knee_pitch));
    let ankle_pitch = -lean - atan2f(to_hip.x, lower);

    let tilt = side.sign() * FRAC_PI_4;
    let below_hip = Mat3A::from_rotation_y(knee_pitch + ankle_pitch) * Mat3A::from_rotation_x(ankle_roll);
    let m = Mat3A::from_rotation_x(-tilt) * rotation * below_hip.transpose();
    LegAngles {
        hip_yaw_pitch: -side.sign() * atan2f(-m.y_axis.x, m.y_axis.y),
        hip_roll: atan2f(m.y_axis.z, hypotf(m.y_axis.x, m.y_axis.y)) + tilt,
        hip_pitch: atan2f(-m.x_axis.z, m.z_axis.z),
        knee_pitch,
        ankle_pitch,
        ankle_roll,
    }
}

/// The angles that bring a foot to a place and its sole parallel to the wanted pose's, with a given yaw-pitch, rad.
///
/// The foot's yaw becomes what the yaw-pitch makes of it. `ankle` and out-of-reach places as in [`leg_angles`].
#[must_use]
pub fn leg_angles_at(side: Side, ankle: &Affine3A, hip_yaw_pitch: f32) -> LegAngles {
    let tilt = side.sign() * FRAC_PI_4;
    let pelvis = Mat3A::from_rotation_x(tilt)
        * Mat3A::from_rotation_z(-side.sign() * hip_yaw_pitch)
        * Mat3A::from_rotation_x(-tilt);
    let to_ankle = pelvis.transpose() * (ankle.translation - hip_of(side));
    let lower = hypotf(to_ankle.y, to_ankle.z);
    let knee_pitch = knee(hypotf(to_ankle.x, lower));
    let hip_roll = atan2f(to_ankle.y, -to_ankle.z);
    let lean = atan2f(TIBIA * sinf(knee_pitch), THIGH + TIBIA * cosf(knee_pitch));
    let hip_pitch = atan2f(-to_ankle.x, lower) - lean;

    let shin = pelvis * Mat3A::from_rotation_x(hip_roll) * Mat3A::from_rotation_y(hip_pitch + knee_pitch);
    let normal = shin.transpose() * ankle.matrix3.z_axis;
    LegAngles {
        hip_yaw_pitch,
        hip_roll,
        hip_pitch,
        knee_pitch,
        ankle_pitch: atan2f(normal.x, normal.z),
        ankle_roll: atan2f(-normal.y, hypotf(normal.x, normal.z)),
    }
}

/// The angles of both legs, left first, for both feet's poses, with the shared yaw-pitch chosen by `yaw`.
///
/// Poses as in [`leg_angles`]. The chosen yaw-pitch is kept within its joint's limits.
#[must_use]
pub fn legs_angles(left: &Affine3A, right: &Affine3A, yaw: YawFrom) -> [LegAngles; 2] {
    let of_left = || leg_angles(Side::Left, left).hip_yaw_pitch;
    let of_right = || leg_angles(Side::Right, right).hip_yaw_pitch;
    let shared = match yaw {
        YawFrom::Mean => 0.5 * (of_left() + of_right()),
        YawFrom::Leg(Side::Left) => of_left(),
        YawFrom::Leg(Side::Right) => of_right(),
        YawFrom::Angle(angle) => angle,
    };
    let shared = crate::limits::limit(Joint::LHipYawPitch).clamp(shared);
    [leg_angles_at(Side::Left, left, shared), leg_angles_at(Side::Right, right, shared)]
}

fn hip_of(side: Side) -> Vec3A {
    Vec3A::new(HIP.x, side.sign() * HIP.y, HIP.z)
}

/// The knee angle that sets hip and ankle `distance` apart; the half-angle form stays accurate near the straight leg.
fn knee(distance: f32) -> f32 {
    let opened = (THIGH + TIBIA - distance) * (THIGH + TIBIA + distance);
    let closed = (distance - (TIBIA - THIGH)) * (distance + (TIBIA - THIGH));
    2.0 * atan2f(sqrtf(opened.max(0.0)), sqrtf(closed.max(0.0)))
}
