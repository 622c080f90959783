//! Range, speed and aim of the head.

use glam::Vec3;
use libm::{asinf, atan2f, hypotf, sincosf};

use crate::bounds::clamp;
use crate::joints::{Joint, Joints};
use crate::kinematics::ground_from_robot;
use crate::model::{CameraMount, HeadSpeed, Range, RobotModel};
use crate::robot::CameraId;
use crate::side::Side;

/// Angles of the head.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub struct HeadAngles {
    /// Yaw, rad; positive to the left.
    pub yaw: f32,
    /// Pitch, rad; positive down.
    pub pitch: f32,
}

/// Pitch range at a yaw, rad, interpolated linearly in [`RobotModel::head_pitch_limits`].
///
/// Beyond the last yaw, and for NaN, the range at the last yaw.
#[must_use]
pub fn pitch_range(model: &RobotModel, yaw: f32) -> Range {
    let limits = model.head_pitch_limits;
    let yaw = yaw.abs().to_degrees();
    let last = limits[limits.len() - 1];
    let (mut min, mut max) = (last.min, last.max);
    for pair in limits.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        if (from.yaw..to.yaw).contains(&yaw) {
            let share = (yaw - from.yaw) / (to.yaw - from.yaw);
            min = from.min + share * (to.min - from.min);
            max = from.max + share * (to.max - from.max);
        }
    }
    Range { min: min.to_radians(), max: max.to_radians() }
}

impl HeadAngles {
    /// Straight ahead.
    pub const AHEAD: Self = Self { yaw: 0.0, pitch: 0.0 };

    /// Nearest angles within the limits; the yaw has priority.
    #[must_use]
    pub fn clamped(&self, model: &RobotModel) -> Self {
        let yaw = model.limits[Joint::HeadYaw].clamp(self.yaw);
        Self { yaw, pitch: pitch_range(model, yaw).clamp(self.pitch) }
    }

    /// Reads the head's angles.
    #[must_use]
    pub fn read(angles: &Joints) -> Self {
        Self { yaw: angles[Joint::HeadYaw], pitch: angles[Joint::HeadPitch] }
    }

    /// Writes both angles.
    pub fn write(&self, angles: &mut Joints) {
        angles[Joint::HeadYaw] = self.yaw;
        angles[Joint::HeadPitch] = self.pitch;
    }
}

/// Head angles at which a point lies on the optical axis of a camera.
///
/// `point` is in the robot frame, m. The result may exceed the limits ([`HeadAngles::clamped`] applies them). It is
/// arbitrary for points within a few centimetres of the neck, for which no solution exists.
#[must_use]
pub fn look_at(model: &RobotModel, camera: CameraId, point: Vec3) -> HeadAngles {
    let CameraMount { position, tilt, .. } = model.dimensions.camera(camera);
    let (ahead, up) = (hypotf(point.x, point.y), point.z - model.dimensions.neck.z);
    // Distance of the optical axis from the neck, independent of the pitch.
    let (sin, cos) = sincosf(tilt);
    let over_neck = position.x * sin + position.z * cos;
    let down = asinf((over_neck / hypotf(ahead, up)).clamp(-1.0, 1.0)) - atan2f(up, ahead);
    HeadAngles { yaw: atan2f(point.y, point.x), pitch: down - tilt }
}

/// As [`look_at`], for a point in the [ground frame](crate::kinematics::ground_from_robot), with the robot on its
/// `support` foot and its joints at `angles`.
#[must_use]
pub fn look_at_over_ground(
    model: &RobotModel,
    camera: CameraId,
    point: Vec3,
    support: Side,
    angles: &Joints,
) -> HeadAngles {
    look_at(model, camera, ground_from_robot(model, support, angles).inverse().transform_point3(point))
}

impl HeadSpeed {
    /// Next angles on the way from `now` to `target`, `dt` seconds later.
    ///
    /// The result is within the limits. Where a larger yaw narrows the pitch range, the pitch follows the range, which
    /// adds up to half of the yaw's speed to the pitch's speed.
    #[must_use]
    pub fn step(&self, model: &RobotModel, now: HeadAngles, target: HeadAngles, dt: f32) -> HeadAngles {
        let target = target.clamped(model);
        let toward = |now: f32, target: f32, speed: f32| {
            let most = if dt > 0.0 { speed * dt } else { 0.0 };
            now + clamp(target - now, -most, most)
        };
        let now = now.clamped(model);
        let yaw = toward(now.yaw, target.yaw, self.yaw);
        let pitch = toward(now.pitch, target.pitch, self.pitch);
        HeadAngles { yaw, pitch }.clamped(model)
    }
}
