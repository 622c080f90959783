//! Parameters of the physics, and faults for experiments.

use bica_motion::joints::Joint;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::side::Side;

use super::error::Error;

/// Parameters that differ between robots and between floors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Physics {
    /// Coefficient of friction between soles and carpet, 0.05 to 3.
    pub friction: f32,
    /// Factor on the position gains of the leg motors; 0.1 to 5.
    pub leg_gain: f32,
    /// Torque limit of the knees, Nm, 0.5 to 100; those of the other leg joints change in proportion.
    pub torque_limit: f32,
    /// Dead time from a command to its first effect on a motor, s, 0 to 0.2. A NAO has 30 ms (B-Human 2015).
    pub dead_time: f32,
    /// Age of the measurements of the body's sensors, s, 0 to 0.2. The latency from a command to its first effect in the
    /// measurements is 36 ms (B-Human 2023); without the dead time, 6 ms remain.
    pub sensor_delay: f32,
    /// Factor on the noise of the body's sensors, 0 to 100: 1 is the noise of a NAO (B-Human 2023), 0 is none.
    pub noise: f32,
    /// Whether a world with cameras renders their images. Without them the simulation is faster and needs no renderer.
    pub cameras: bool,
}

/// A permanent fault of the robot. For experiments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fault {
    /// The gyroscope measures zero.
    Gyroscope,
    /// The pressure sensors of a sole measure zero.
    SoleSensors(Side),
    /// The motor of a joint has no torque.
    Motor(Joint),
}

impl Physics {
    /// Returns the physics of a robot model on a carpet, with camera images.
    #[must_use]
    pub fn of(model: &'static SimulatedModel) -> Self {
        Self {
            friction: 1.0,
            leg_gain: 1.0,
            torque_limit: model.mujoco.torque_limits[Joint::LKneePitch],
            dead_time: model.dead_time,
            sensor_delay: 0.006,
            noise: 1.0,
            cameras: true,
        }
    }

    /// Checks the ranges of all parameters.
    ///
    /// # Errors
    ///
    /// If a parameter is outside its range; the error names it.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let parameters = [
            ("friction", self.friction, (0.05, 3.0)),
            ("leg_gain", self.leg_gain, (0.1, 5.0)),
            ("torque_limit", self.torque_limit, (0.5, 100.0)),
            ("dead_time", self.dead_time, (0.0, 0.2)),
            ("sensor_delay", self.sensor_delay, (0.0, 0.2)),
            ("noise", self.noise, (0.0, 100.0)),
        ];
        for (name, value, range) in parameters {
            if !(range.0..=range.1).contains(&value) {
                return Err(Error::Physics { name, value, range });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;

    #[test]
    fn latency_is_that_of_nao() {
        let Physics { dead_time, sensor_delay, noise, .. } = Physics::of(TEST_MODEL);
        // Dead time: B-Human 2015, 4.1.1.1. Latency from command to measurement: B-Human 2023, `minDelay`.
        assert_eq!((dead_time, noise), (0.030, 1.0));
        assert!((dead_time + sensor_delay - 0.036).abs() < 1e-6);
    }

    #[test]
    fn parameter_outside_its_range_is_rejected_by_name() {
        assert_eq!(Physics::of(TEST_MODEL).check(), Ok(()));
        for (name, wrong) in [
            ("friction", Physics { friction: f32::NAN, ..Physics::of(TEST_MODEL) }),
            ("torque_limit", Physics { torque_limit: -1.0, ..Physics::of(TEST_MODEL) }),
            ("dead_time", Physics { dead_time: 30.0, ..Physics::of(TEST_MODEL) }),
        ] {
            let error = wrong.check().unwrap_err();
            assert!(error.to_string().contains(name), "{error}");
        }
    }
}
