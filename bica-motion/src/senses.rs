//! Estimates of what a robot does not measure: tilt of the torso, and forces on the soles.

use glam::{Affine3A, Vec3, Vec3A};
use libm::{asinf, atan2f};

use crate::bounds::clamp;
use crate::joints::Joints;
use crate::kinematics::sole;
use crate::model::RobotModel;
use crate::robot::{FootPressure, Inertial, Sensors};
use crate::side::Side;

/// Gravity, m/s².
const GRAVITY: f32 = 9.81;
/// Rate at which the accelerometer corrects the tilt, 1/s: it is noisy in walking, the gyroscope drifts slowly.
const CORRECTION: f32 = 0.6;
/// Deviation of the specific force from gravity at which it corrects nothing, as a share of gravity.
const MAX_DEVIATION: f32 = 0.5;
/// Difference of the soles' heights over which the weight passes from one to the other, m.
const WEIGHT_SHIFT: f32 = 0.008;
/// Specific force below which the robot falls freely, as a share of gravity.
const FREE_FALL: f32 = 0.3;

/// Estimator for the robots whose [`Senses`](crate::model::Senses) lack something; measured values pass unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SenseEstimator {
    /// Vertical direction in the torso frame.
    up: Vec3,
    model: &'static RobotModel,
}

impl SenseEstimator {
    /// Begins with an upright torso.
    #[must_use]
    pub const fn new(model: &'static RobotModel) -> Self {
        Self { up: Vec3::Z, model }
    }

    /// Completes the measurements of one cycle of `dt` s.
    pub fn complete(&mut self, sensors: &mut Sensors<'_>, dt: f32) {
        if !self.model.senses.tilt {
            self.tilt(&mut sensors.inertial, dt);
        }
        if !self.model.senses.soles {
            [sensors.left_foot, sensors.right_foot] = self.forces(&sensors.angles, &sensors.inertial);
        }
    }

    /// Integrates the gyroscope and turns the result slowly to the specific force (complementary filter, Mahony 2008).
    fn tilt(&mut self, inertial: &mut Inertial, dt: f32) {
        let (gyro, force) = (inertial.gyro, inertial.acceleration / GRAVITY);
        if gyro.is_finite() && force.is_finite() {
            let trust = (1.0 - (force.length() - 1.0).abs() / MAX_DEVIATION).max(0.0);
            let turned = self.up - gyro.cross(self.up) * dt + (force - self.up) * (CORRECTION * trust * dt);
            self.up = turned.try_normalize().unwrap_or(Vec3::Z);
        }
        inertial.roll = atan2f(self.up.y, self.up.z);
        inertial.pitch = asinf(clamp(-self.up.x, -1.0, 1.0));
    }

    /// The lower sole bears the weight; with equal heights both bear half of it.
    fn forces(&self, angles: &Joints, inertial: &Inertial) -> [FootPressure; 2] {
        let up: Vec3A = self.up.into();
        let height = |pose: Affine3A| pose.translation.dot(up);
        let [left, right] = Side::BOTH.map(|side| height(sole(self.model, side, angles)));
        let weight =
            if inertial.acceleration.length() < FREE_FALL * GRAVITY { 0.0 } else { self.model.total_mass() * GRAVITY };
        let share = clamp(0.5 + 0.5 * (right - left) / WEIGHT_SHIFT, 0.0, 1.0);
        [share, 1.0 - share].map(|share| {
            let corner = 0.25 * share * weight;
            FootPressure { front_left: corner, front_right: corner, rear_left: corner, rear_right: corner }
        })
    }
}
