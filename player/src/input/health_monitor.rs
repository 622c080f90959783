//! Faults of the body.

use bica::prelude::*;
use bica_motion::health::{Fault, Health};
use bica_motion::joints::Joints;
use bica_motion::robot::Sensors;

use super::RobotState;
use crate::Model;
use crate::output::JointCommand;

/// Maximum time from a fault to the end of the motion if the feet are never both on the ground, s. A kick takes less.
const GRACE_TIME: f32 = 3.0;

/// Faults of joints, motors and sensors, and the reduction of the stiffness of hot motors.
#[derive(Clone, Copy, Debug)]
pub struct HealthMonitor {
    health: Health<Model>,
    /// Remaining time until a fault ends the motion, s; 0 or less: it ends the motion.
    grace: f32,
}

#[component(budget_us = 2)]
impl HealthMonitor {
    /// Creates the component without a fault.
    #[must_use]
    pub const fn new() -> Self {
        Self { health: Health::new(), grace: GRACE_TIME }
    }

    /// Compares the measurements of this cycle with the command of the previous one.
    pub fn check(&mut self, sensors: &Sensors<'_>, commanded: &JointCommand) {
        self.health.step(sensors, &commanded.targets, &commanded.stiffness);
    }

    fn step(&mut self, time: &Time, state: &RobotState) {
        self.grace = match self.fault() {
            None => GRACE_TIME,
            Some(_) if state.grounded() => 0.0,
            Some(_) => self.grace - time.dt(),
        };
    }

    /// The fault, if there is one.
    #[must_use]
    pub const fn fault(&self) -> Option<Fault> {
        self.health.fault()
    }

    /// Whether a fault ends the current motion: both feet have touched the ground since, or 3 s have passed.
    #[must_use]
    pub fn must_stop(&self) -> bool {
        self.grace <= 0.0
    }

    /// Stiffness to command instead of `stiffness` (both 0 to 1): less for joints whose motors are hot or heavily
    /// loaded ([`Health::derated`]).
    #[must_use]
    pub fn derated(&self, stiffness: &Joints) -> Joints {
        self.health.derated(stiffness)
    }
}
