//! The head: how far it turns, how fast, and where it must turn to look at something.

use crate::bounds::clamp;
use glam::Vec3;
use libm::{asinf, atan2f, cosf, hypotf, sinf};

use crate::dimensions::{BOTTOM_CAMERA, BOTTOM_CAMERA_TILT, NECK, TOP_CAMERA, TOP_CAMERA_TILT};
use crate::joints::{Joint, Joints};
use crate::kinematics::ground_from_robot;
use crate::limits::{Range, limit};
use crate::robot::CameraId;
use crate::side::Side;

/// Where the head turns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HeadAngles {
    /// Positive to the left, rad.
    pub yaw: f32,
    /// Positive down, rad.
    pub pitch: f32,
}

/// Yaw and the least and the most pitch there, degrees: the head's shell would hit the shoulders. The same to both sides.
/// Sources: Aldebaran's joints page, B-Human 2023 `headLimits.cfg`.
const PITCH_LIMITS: [(f32, f32, f32); 7] = [
    (0.0, -38.50, 29.50),
    (27.85, -38.50, 24.18),
    (43.32, -31.40, 21.20),
    (51.74, -27.50, 18.91),
    (62.45, -24.64, 17.19),
    (87.49, -18.91, 11.46),
    (119.52, -25.73, 18.91),
];

/// The pitch that is possible at a yaw, rad; between the known yaws linear. Beyond the last yaw, and for a yaw that is
/// no number, the range of the last.
#[must_use]
pub fn pitch_range(yaw: f32) -> Range {
    let yaw = yaw.abs().to_degrees();
    let last = PITCH_LIMITS[PITCH_LIMITS.len() - 1];
    let (mut min, mut max) = (last.1, last.2);
    for pair in PITCH_LIMITS.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        if (from.0..to.0).contains(&yaw) {
            let share = (yaw - from.0) / (to.0 - from.0);
            min = from.1 + share * (to.1 - from.1);
            max = from.2 + share * (to.2 - from.2);
        }
    }
    Range { min: min.to_radians(), max: max.to_radians() }
}

impl HeadAngles {
    /// Straight ahead.
    pub const AHEAD: Self = Self { yaw: 0.0, pitch: 0.0 };

    /// The nearest angles that the head can take, yaw first.
    #[must_use]
    pub fn clamped(&self) -> Self {
        let yaw = limit(Joint::HeadYaw).clamp(self.yaw);
        Self { yaw, pitch: pitch_range(yaw).clamp(self.pitch) }
    }

    /// The head's angles among all.
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

/// The angles at which a point lies on a camera's optical axis, so that it is seen in the middle of the image.
///
/// `point` in the robot frame, m. The result may be beyond what the head can do ([`HeadAngles::clamped`] brings it
/// there). Points within a few centimetres of the neck, where no angle is right, give some angle.
#[must_use]
pub fn look_at(camera: CameraId, point: Vec3) -> HeadAngles {
    let (place, tilt) = match camera {
        CameraId::Top => (TOP_CAMERA, TOP_CAMERA_TILT),
        CameraId::Bottom => (BOTTOM_CAMERA, BOTTOM_CAMERA_TILT),
    };
    let (ahead, up) = (hypotf(point.x, point.y), point.z - NECK.z);
    // The axis passes the neck at this distance, whatever the pitch.
    let over_neck = place.x * sinf(tilt) + place.z * cosf(tilt);
    let down = asinf((over_neck / hypotf(ahead, up)).clamp(-1.0, 1.0)) - atan2f(up, ahead);
    HeadAngles { yaw: atan2f(point.y, point.x), pitch: down - tilt }
}

/// As [`look_at`], for a point in the [ground](crate::kinematics::ground_from_robot) frame, with the robot on its
/// `support` foot and its joints at `angles`.
#[must_use]
pub fn look_at_over_ground(camera: CameraId, point: Vec3, support: Side, angles: &Joints) -> HeadAngles {
    look_at(camera, ground_from_robot(support, angles).inverse().transform_point3(point))
}

/// A head that turns no faster than it may.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeadMotion {
    /// rad/s.
    pub yaw_speed: f32,
    /// rad/s.
    pub pitch_speed: f32,
}

impl HeadMotion {
    /// Calm enough for images without blur: 3.0 rad/s aside and 0.8 rad/s up and down. Source: HULKs 2025.
    pub const CALM: Self = Self { yaw_speed: 3.0, pitch_speed: 0.8 };

    /// Where to send the head next on its way from `now` to `target`, when `dt` seconds have passed.
    ///
    /// The result is always possible: the pitch gives way where turning narrows its range, with up to another half of
    /// the yaw's speed.
    #[must_use]
    pub fn step(&self, now: HeadAngles, target: HeadAngles, dt: f32) -> HeadAngles {
        let target = target.clamped();
        let toward = |now: f32, target: f32, speed: f32| {
            let most = if dt > 0.0 { speed * dt } else { 0.0 };
            now + clamp(target - now, -most, most)
        };
        let now = now.clamped();
        let yaw = toward(now.yaw, target.yaw, self.yaw_speed);
        let pitch = toward(now.pitch, target.pitch, self.pitch_speed);
        HeadAngles { yaw, pitch }.clamped()
    }
}
