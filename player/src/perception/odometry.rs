//! Odometry.

use bica::prelude::*;
use bica_motion::odometry::{Calibration, MotionInput, Odometry as Estimator};
use bica_motion::pose::Pose2;

use crate::Model;
use crate::input::{RobotProfile, RobotState};

/// The robot's pose relative to its start: displacement from the support leg, commanded and measured, and rotation from
/// the gyroscope.
#[derive(Debug)]
pub struct Odometry {
    estimator: Estimator<Model>,
}

#[component(budget_us = 10)]
impl Odometry {
    /// Creates the component at the origin.
    #[must_use]
    pub const fn new() -> Self {
        Self { estimator: Estimator::new(&Calibration::EXACT) }
    }

    fn step(&mut self, time: &Time, state: &RobotState, profile: &RobotProfile) {
        self.estimator.set_calibration(&profile.get().odometry);
        self.estimator.step(&MotionInput {
            commanded: state.commanded(),
            angles: state.angles(),
            feet: state.feet(),
            gyro_turn: Some(state.inertial().gyro.z * time.dt()),
        });
    }

    /// The pose of the point on the ground between the feet, in the frame of the start.
    #[must_use]
    pub const fn pose(&self) -> Pose2 {
        self.estimator.pose()
    }
}
