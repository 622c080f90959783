//! Kinematics of a leg with hip yaw-pitch, hip roll, hip pitch, knee pitch, ankle pitch and ankle roll, in closed form.
//!
//! [`RobotModel`](super::RobotModel) calls these functions. Inverse kinematics, own derivation: in the
//! frame of the foot, the distance to the hip gives the knee angle, and the direction to the hip gives both ankle
//! angles. The remaining rotation belongs to the hip.

use core::f32::consts::FRAC_PI_4;

use glam::{Affine3A, Mat3A, Vec3, Vec3A};
use libm::{atan2f, hypotf, sincosf, sqrtf};

use crate::limbs::LegAngles;
use crate::model::Dimensions;
use crate::side::Side;

/// Poses of pelvis, hip, thigh, tibia, ankle and foot in the robot frame.
pub(super) fn poses(
    dimensions: &Dimensions,
    side: Side,
    [yaw_pitch, hip_roll, hip_pitch, knee, pitch, roll]: [f32; 6],
) -> [Affine3A; 6] {
    let Dimensions { hip, thigh, tibia, .. } = *dimensions;
    let tilt = side.sign() * FRAC_PI_4;
    let at_hip = Vec3::new(hip.x, side.sign() * hip.y, hip.z);
    let pelvis = at(at_hip) * about_x(tilt) * Affine3A::from_rotation_z(-side.sign() * yaw_pitch) * about_x(-tilt);
    let hip = pelvis * about_x(hip_roll);
    let upper = hip * about_y(hip_pitch);
    let lower = upper * at(Vec3::new(0.0, 0.0, -thigh)) * about_y(knee);
    let ankle = lower * at(Vec3::new(0.0, 0.0, -tibia)) * about_y(pitch);
    [pelvis, hip, upper, lower, ankle, ankle * about_x(roll)]
}

/// Angles that bring a foot to a pose.
pub(super) fn angles(dimensions: &Dimensions, side: Side, ankle: &Affine3A) -> LegAngles {
    let Dimensions { thigh, tibia, .. } = *dimensions;
    let hip = hip(dimensions, side);
    let rotation = ankle.matrix3;
    let to_hip = -(rotation.transpose() * (ankle.translation - hip));
    // A crouch can bring the hip under the plane of the foot; the ankle's roll never passes 90° for it.
    let over = if to_hip.z < 0.0 { -1.0 } else { 1.0 };
    let lower = over * hypotf(to_hip.y, to_hip.z);
    let knee_pitch = knee(dimensions, hypotf(to_hip.x, lower));
    let ankle_roll = atan2f(over * to_hip.y, over * to_hip.z);
    let (sin, cos) = sincosf(knee_pitch);
    let lean = atan2f(thigh * sin, tibia + thigh * cos);
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

/// Angles that bring a foot to a place with its sole parallel to the given pose, at a given hip yaw-pitch.
pub(super) fn angles_at(dimensions: &Dimensions, side: Side, ankle: &Affine3A, hip_yaw_pitch: f32) -> LegAngles {
    let Dimensions { thigh, tibia, .. } = *dimensions;
    let tilt = side.sign() * FRAC_PI_4;
    let pelvis = Mat3A::from_rotation_x(tilt)
        * Mat3A::from_rotation_z(-side.sign() * hip_yaw_pitch)
        * Mat3A::from_rotation_x(-tilt);
    let to_ankle = pelvis.transpose() * (ankle.translation - hip(dimensions, side));
    let lower = hypotf(to_ankle.y, to_ankle.z);
    let knee_pitch = knee(dimensions, hypotf(to_ankle.x, lower));
    let hip_roll = atan2f(to_ankle.y, -to_ankle.z);
    let (sin, cos) = sincosf(knee_pitch);
    let lean = atan2f(tibia * sin, thigh + tibia * cos);
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

fn hip(dimensions: &Dimensions, side: Side) -> Vec3A {
    let hip = dimensions.hip;
    Vec3A::new(hip.x, side.sign() * hip.y, hip.z)
}

/// Knee angle that sets hip and ankle `distance` apart. The half-angle form stays accurate near the straight leg.
fn knee(dimensions: &Dimensions, distance: f32) -> f32 {
    let Dimensions { thigh, tibia, .. } = *dimensions;
    let opened = (thigh + tibia - distance) * (thigh + tibia + distance);
    let closed = (distance - (tibia - thigh)) * (distance + (tibia - thigh));
    2.0 * atan2f(sqrtf(opened.max(0.0)), sqrtf(closed.max(0.0)))
}

fn at(place: Vec3) -> Affine3A {
    Affine3A::from_translation(place)
}

fn about_x(angle: f32) -> Affine3A {
    Affine3A::from_rotation_x(angle)
}

fn about_y(angle: f32) -> Affine3A {
    Affine3A::from_rotation_y(angle)
}
