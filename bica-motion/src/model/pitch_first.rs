//! Kinematics of a leg with hip pitch, hip roll, hip yaw, knee pitch, ankle pitch and ankle roll, each with its own axis.
//!
//! Inverse kinematics, own derivation: roll and yaw of the hip intersect in a point, which circles around the axis of the hip
//! pitch. If it is known, the leg's plane gives the ankle roll, two lengths give the knee, and directions give all other angles
//! in closed form. The hip pitch that results moves the point by its small offset, 5 to 7 % of the leg, so the formulas are
//! repeated with the secant method. They are singular at a hip roll of 90°.

use glam::{Affine3A, Mat3A, Vec2, Vec3, Vec3A};
use libm::{asinf, atan2f, hypotf, sincosf, sqrtf};

use crate::limbs::LegAngles;
use crate::side::Side;

/// Maximum number of repetitions of the inverse kinematics; a walk needs three.
const REPETITIONS: usize = 8;
/// Change of the hip pitch at which they end, rad.
const PRECISION: f32 = 3e-6;
/// Maximum change of the error per change of the hip pitch; near a singularity it would vanish.
const MAX_SLOPE: f32 = -0.2;

/// Order of the joints in a leg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LegGeometry {
    /// Hip yaw-pitch with one motor for both legs and an axis tilted by 45°, hip roll, hip pitch, knee, ankle pitch, ankle roll.
    /// All hip axes intersect, both ankle axes intersect.
    SharedYawPitch,
    /// Hip pitch, hip roll, hip yaw, knee, ankle pitch, ankle roll.
    PitchRollYaw(PitchFirstLeg),
}

impl LegGeometry {
    /// Whether one motor turns both hip yaws.
    #[must_use]
    pub const fn shares_hip_yaw(&self) -> bool {
        matches!(self, Self::SharedYawPitch)
    }
}

/// Offsets between the joints of the left leg, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PitchFirstLeg {
    /// Hip pitch to hip roll; y is 0.
    pub roll: Vec3,
    /// Hip roll to hip yaw; y is 0.
    pub yaw: Vec3,
    /// Hip yaw to knee; y is 0.
    pub knee: Vec3,
    /// Knee to ankle pitch.
    pub ankle: Vec3,
    /// Ankle pitch to ankle roll; x is 0.
    pub ankle_roll: Vec3,
}

impl PitchFirstLeg {
    /// Poses of pelvis (moved by the pitch), hip (by the roll), thigh (by the yaw), tibia, ankle and foot.
    pub(super) fn poses(
        &self,
        side: Side,
        hip: Vec3,
        [yaw, hip_roll, hip_pitch, knee, pitch, roll]: [f32; 6],
    ) -> [Affine3A; 6] {
        let at = |left: Vec3| Affine3A::from_translation(on(side, left));
        let pelvis = at(hip) * Affine3A::from_rotation_y(hip_pitch);
        let hip = pelvis * at(self.roll) * Affine3A::from_rotation_x(hip_roll);
        let thigh = hip * at(self.yaw) * Affine3A::from_rotation_z(yaw);
        let tibia = thigh * at(self.knee) * Affine3A::from_rotation_y(knee);
        let ankle = tibia * at(self.ankle) * Affine3A::from_rotation_y(pitch);
        [pelvis, hip, thigh, tibia, ankle, ankle * at(self.ankle_roll) * Affine3A::from_rotation_x(roll)]
    }

    /// Angles that bring a foot to a pose.
    pub(super) fn angles(&self, side: Side, hip: Vec3, foot: &Affine3A) -> LegAngles {
        let hip: Vec3A = on(side, hip).into();
        // From the axis of the hip pitch to the point in which roll and yaw intersect.
        let offset = Vec3A::new(self.roll.x + self.yaw.x, 0.0, self.roll.z);
        let (mut pitch, mut before, mut angles) = (0.0, None, LegAngles::default());
        for _ in 0..REPETITIONS {
            angles = self.angles_from(side, hip + Mat3A::from_rotation_y(pitch) * offset, foot);
            let error = angles.hip_pitch - pitch;
            if error.abs() < PRECISION {
                break;
            }
            let slope = before.map_or(-1.0, |(old_pitch, old_error)| (error - old_error) / (pitch - old_pitch));
            before = Some((pitch, error));
            pitch -= error / slope.min(MAX_SLOPE);
        }
        angles
    }

    /// Angles of a leg whose hip roll and hip yaw intersect in this point of the robot frame.
    fn angles_from(&self, side: Side, point: Vec3A, foot: &Affine3A) -> LegAngles {
        let to_hip = foot.matrix3.transpose() * (point - foot.translation);
        let over = if to_hip.z < 0.0 { -1.0 } else { 1.0 };
        let lower = hypotf(to_hip.y, to_hip.z);
        let aside = side.sign() * (self.ankle.y + self.ankle_roll.y);
        let ankle_roll = atan2f(over * to_hip.y, over * to_hip.z) + asinf((over * aside / lower).clamp(-1.0, 1.0));
        // In the leg's plane: x ahead, y up, from the ankle pitch to the point.
        let (sin, cos) = sincosf(ankle_roll);
        let up = sin * to_hip.y + cos * to_hip.z;
        let leg = Vec2::new(to_hip.x, up + self.ankle_roll.z);
        let upper = Vec2::new(self.knee.x, self.knee.z + self.yaw.z);
        let shank = Vec2::new(self.ankle.x, self.ankle.z);
        let knee_pitch = bend(upper.length(), shank.length(), leg.length()) + angle(upper) - angle(shank);
        let down = upper + Vec2::from_angle(-knee_pitch).rotate(shank);
        let below_hip = angle(down) - angle(-leg);
        let turn = foot.matrix3 * Mat3A::from_rotation_x(-ankle_roll) * Mat3A::from_rotation_y(-below_hip);
        let [x, y, z] = turn.z_axis.to_array();
        LegAngles {
            hip_yaw_pitch: atan2f(turn.x_axis.y, turn.y_axis.y),
            hip_roll: atan2f(-y, hypotf(x, z)),
            hip_pitch: atan2f(x, z),
            knee_pitch,
            ankle_pitch: below_hip - knee_pitch,
            ankle_roll,
        }
    }
}

/// Angle between two links that sets their ends `distance` apart; 0 if they are straight.
fn bend(upper: f32, lower: f32, distance: f32) -> f32 {
    let opened = (upper + lower - distance) * (upper + lower + distance);
    let closed = (distance - (upper - lower)) * (distance + (upper - lower));
    2.0 * atan2f(sqrtf(opened.max(0.0)), sqrtf(closed.max(0.0)))
}

/// Angle about the y axis of a vector in the x-z plane, 0 down.
fn angle(vector: Vec2) -> f32 {
    atan2f(-vector.x, -vector.y)
}

fn on(side: Side, left: Vec3) -> Vec3 {
    Vec3::new(left.x, side.sign() * left.y, left.z)
}
