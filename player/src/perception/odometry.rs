//! The way that the robot made.

use bica::prelude::*;
use bica_motion::odometry::{Calibration, MotionInput, Odometry as Estimate};
use bica_motion::pose::Pose2;

use crate::input::Measured;

/// Where the robot is, seen from where it started: the way by the foot that carries it, as told and
/// as measured, the turn by the gyroscope.
#[derive(Debug)]
pub struct Odometry {
    estimate: Estimate,
}

#[component(budget_us = 10)]
impl Odometry {
    /// At the origin.
    #[must_use]
    pub const fn new() -> Self {
        Self { estimate: Estimate::new(&Calibration::EXACT) }
    }

    fn step(&mut self, time: &Time, body: &Measured) {
        self.estimate.set_calibration(&body.profile().odometry);
        let (left, right) = body.feet();
        let turned = Some(body.inertial().gyro.z * time.dt());
        self.estimate.step(&MotionInput {
            commanded: body.commanded(),
            angles: body.angles(),
            feet: [left, right],
            gyro_turn: turned,
        });
    }

    /// The ground between the feet, in the frame of where the robot started.
    #[must_use]
    pub const fn pose(&self) -> Pose2 {
        self.estimate.pose()
    }
}
