//! Odometry.

use bica::prelude::*;
use bica::visual;
use bica_motion::model::RobotModel;
use bica_motion::odometry::{Calibration, LegsTurn, MotionInput, Odometry as Estimator, OdometryTuning};
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use glam::Vec2;

use super::ego_motion::Age;
use crate::MODEL;
use crate::input::{RobotProfile, RobotState};
use crate::shapes;

/// Corrections and errors of the odometry. The scales are factors on the profile's scales.
#[derive(Params)]
pub struct OdometryCorrection {
    /// Factor on the displacement forward and backward.
    #[param(default = 1.0, range = 0.5..=2.0, step = 0.01)]
    forward_scale: f32,
    /// Factor on the displacement to the sides.
    #[param(default = 1.0, range = 0.5..=2.0, step = 0.01)]
    sideways_scale: f32,
    /// Factor on the turn.
    #[param(default = 1.0, range = 0.5..=2.0, step = 0.01)]
    turn_scale: f32,
    /// Difference of the forces on both feet, relative to their sum, from which measured angles have full weight over commanded
    /// ones.
    #[param(default = 0.5, range = 0.05..=1.0, step = 0.05)]
    full_trust: f32,
    /// Standard deviation of the position after 1 m of walking; it grows with the square root of the distance.
    #[param(default = 0.08, range = 0.0..=1.0, unit = "m", step = 0.01)]
    distance_error: f32,
    /// Standard deviation of the heading after a turn of 1 rad; it grows with the square root of the turn.
    #[param(default = 0.05, range = 0.0..=1.0, unit = "rad", step = 0.01)]
    turn_error: f32,
}

impl OdometryCorrection {
    const fn tuning(&self) -> OdometryTuning {
        OdometryTuning {
            full_trust: self.full_trust,
            distance_scale: Vec2::new(self.forward_scale, self.sideways_scale),
            turn_scale: self.turn_scale,
        }
    }
}

/// The robot's pose relative to its start: displacement from the support leg, commanded and measured, and rotation from
/// the gyroscope.
#[derive(Debug)]
pub struct Odometry {
    estimator: Estimator,
    distance_error: f32,
    turn_error: f32,
    age: Age,
}

#[component(budget_us = 10)]
impl Odometry {
    /// Creates the component at the origin.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            estimator: Estimator::new(MODEL, &Calibration::EXACT),
            distance_error: OdometryCorrection::DEFAULT.distance_error,
            turn_error: OdometryCorrection::DEFAULT.turn_error,
            age: Age::new(),
        }
    }

    /// Sets the model of the controlled robot, see [`set_model`](crate::model::set_model).
    pub(crate) const fn set_model(&mut self, model: &'static RobotModel) {
        self.estimator = Estimator::new(model, &Calibration::EXACT);
    }

    fn step(&mut self, tuned: &Tuned<OdometryCorrection>, time: &Time, state: &RobotState, profile: &RobotProfile) {
        (self.distance_error, self.turn_error) = (tuned.distance_error, tuned.turn_error);
        self.estimator.set_calibration(&profile.get().odometry);
        let input = MotionInput {
            commanded: state.commanded(),
            angles: state.angles(),
            feet: state.feet(),
            gyro_turn: Some(state.inertial().gyro.z * time.dt()),
        };
        self.estimator.step_tuned(&input, &tuned.tuning());
        self.age.renew();
    }

    /// Counts a cycle since the last run.
    pub(crate) const fn pass_cycle(&mut self) {
        self.age.pass_cycle();
    }

    /// Whether the pose is that of a robot that may have moved in the last half second only: otherwise the way is not known.
    #[must_use]
    pub const fn is_fresh(&self) -> bool {
        self.age.is_fresh()
    }

    /// Turn of the last cycle by the support leg alone; `None` if it did not run in this cycle.
    #[must_use]
    pub const fn legs_turn(&self) -> Option<LegsTurn> {
        if self.age.is_new() { Some(self.estimator.legs_turn()) } else { None }
    }

    /// Standard deviation of the position after 1 m of walking, m.
    #[must_use]
    pub const fn distance_error(&self) -> f32 {
        self.distance_error
    }

    /// Standard deviation of the heading after a turn of 1 rad, rad.
    #[must_use]
    pub const fn turn_error(&self) -> f32 {
        self.turn_error
    }

    /// Pose of the point on the ground between the feet, in the frame of the start.
    #[output(frame = "odometry", child = "robot")]
    fn walked(&self) -> visual::Pose2 {
        shapes::pose(self.pose())
    }

    /// Foot that bears most of the weight, if one does.
    #[output]
    const fn support(&self) -> Option<Side> {
        self.estimator.support()
    }

    /// The pose of the point on the ground between the feet, in the frame of the start.
    #[must_use]
    pub const fn pose(&self) -> Pose2 {
        self.estimator.pose()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_values_correct_nothing() {
        assert_eq!(OdometryCorrection::DEFAULT.tuning(), OdometryTuning::DEFAULT);
    }
}
