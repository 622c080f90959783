//! Faults of the body.

use bica::prelude::*;
use bica_motion::health::{Fault, Health, Senses};
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::RobotModel;
use bica_motion::robot::{Sensors, plausible_temperature};

use super::RobotState;
use crate::MODEL;
use crate::output::JointCommand;
use crate::perception::Odometry;
use crate::roles::Views;

/// Reaction to a fault.
#[derive(Params)]
pub struct FaultReaction {
    /// Maximum time from a fault to the end of the motion if the feet are never both on the ground. A kick takes less.
    #[param(default = 3.0, range = 0.0..=10.0, unit = "s", step = 0.1)]
    grace_time: f32,
}

/// Faults of joints, motors, sensors and camera, and the reduction of the stiffness of hot motors.
#[derive(Clone, Copy, Debug)]
pub struct HealthMonitor {
    health: Health,
    senses: Senses,
    /// Number of the newest image.
    image: u32,
    /// Remaining time until a fault ends the motion, s; 0 or less: it ends the motion.
    grace: f32,
    temperatures: Joints<f32>,
}

#[component(budget_us = 5)]
impl HealthMonitor {
    /// Creates the component without a fault.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            health: Health::new(MODEL),
            senses: Senses::new(),
            image: 0,
            grace: FaultReaction::DEFAULT.grace_time,
            temperatures: Joints([f32::NAN; JOINTS]),
        }
    }

    /// Sets the model of the controlled robot, see [`set_model`](crate::model::set_model).
    pub(crate) const fn set_model(&mut self, model: &'static RobotModel) {
        self.health = Health::new(model);
    }

    /// Compares the measurements of this cycle with the command of the previous one.
    pub fn check(&mut self, sensors: &Sensors<'_>, commanded: &JointCommand) {
        self.temperatures = Joints(sensors.temperatures.0.map(plausible_temperature));
        self.health.step(sensors, &commanded.targets, &commanded.stiffness);
        self.senses.step(sensors, &commanded.targets);
    }

    fn step(
        &mut self,
        tuned: &Tuned<FaultReaction>,
        time: &Time,
        input: &impl Views,
        state: &RobotState,
        odometry: &Odometry,
    ) {
        self.senses.turn(state.inertial(), odometry.legs_turn(), time.dt());
        if self.image != input.count()
            && let Some(glimpse) = input.glimpse()
        {
            self.image = input.count();
            self.senses.see(glimpse);
        }
        self.grace = match self.fault() {
            None => tuned.grace_time,
            Some(_) if state.grounded() => 0.0,
            Some(_) => self.grace - time.dt(),
        };
    }

    /// The fault of joints, motors or sensors, if there is one. The robot sits down.
    #[output]
    #[must_use]
    pub const fn fault(&self) -> Option<Fault> {
        self.health.fault()
    }

    /// The fault of camera or gyroscope, if there is one. The robot stands until it ends.
    #[output]
    #[must_use]
    pub fn sense_fault(&self) -> Option<Fault> {
        self.senses.fault()
    }

    /// Whether a fault ends the current motion: both feet have touched the ground since, or the grace time has passed.
    #[output]
    #[must_use]
    pub fn must_stop(&self) -> bool {
        self.grace <= 0.0
    }

    /// Temperatures of the motors, in the order of [`Joint`]; NaN where unknown.
    #[output(unit = "°C")]
    const fn temperatures(&self) -> [f32; JOINTS] {
        self.temperatures.0
    }

    /// Joint with the hottest motor, if a temperature is known.
    #[output]
    fn hottest_joint(&self) -> Option<Joint> {
        let known = Joint::ALL.into_iter().filter(|joint| !self.temperatures[*joint].is_nan());
        known.max_by(|a, b| self.temperatures[*a].total_cmp(&self.temperatures[*b]))
    }

    /// Share of its stiffness that each joint has left, in the order of [`Joint`], 0 to 1.
    #[output]
    fn stiffness_shares(&self) -> [f32; JOINTS] {
        self.derated(&Joints([1.0; JOINTS])).0
    }

    /// Stiffness to command instead of `stiffness` (both 0 to 1): less for joints whose motors are hot or heavily
    /// loaded ([`Health::derated`]).
    #[must_use]
    pub fn derated(&self, stiffness: &Joints) -> Joints {
        self.health.derated(stiffness)
    }
}

#[cfg(test)]
mod tests {
    use crate::input::CameraInput;

    use super::*;

    /// Monitor of a body of which one motor is too hot, and whose feet are in the air.
    fn hot(temperature: f32) -> HealthMonitor {
        let mut monitor = HealthMonitor::new();
        let mut sensors = Sensors { temperatures: Joints([30.0; JOINTS]), ..Sensors::UNMEASURED };
        sensors.temperatures[Joint::LKneePitch] = temperature;
        let commanded = JointCommand { targets: Joints([0.0; JOINTS]), stiffness: Joints([1.0; JOINTS]) };
        (0..200).for_each(|_| monitor.check(&sensors, &commanded));
        monitor
    }

    fn step(monitor: &mut HealthMonitor, grace_time: f32) {
        monitor.step(
            &Tuned::new(FaultReaction { grace_time }),
            &crate::behaviour::test_time(10),
            &CameraInput::new(),
            &RobotState::new(),
            &Odometry::new(),
        );
    }

    #[test]
    fn shorter_grace_time_ends_the_motion() {
        for (grace_time, must_stop) in [(3.0, false), (0.0, true)] {
            let mut monitor = hot(30.0);
            step(&mut monitor, grace_time);
            monitor.health = hot(150.0).health;
            assert!(monitor.fault().is_some());
            step(&mut monitor, grace_time);
            assert_eq!(monitor.must_stop(), must_stop, "grace time {grace_time}");
        }
    }

    #[test]
    fn the_hottest_joint_is_published() {
        assert_eq!(hot(60.0).hottest_joint(), Some(Joint::LKneePitch));
        assert_eq!(HealthMonitor::new().hottest_joint(), None);
    }
}
