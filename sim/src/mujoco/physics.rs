//! What the physics is like, and what a real robot adds to it.

use bica_motion::joints::Joint;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::side::Side;

use super::error::Error;

/// What may differ from robot to robot and from floor to floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Physics {
    /// How well soles grip the carpet: the greatest sideways force over the weight, 0.05 to 3.
    pub friction: f32,
    /// How hard the legs' motors pull to their targets: a factor on their gain of 40 Nm/rad at full stiffness, 0.1 to 5.
    pub leg_gain: f32,
    /// The greatest torque of the legs' motors, Nm, 0.5 to 20. 5 lies between values published for the robot and its models.
    pub torque_limit: f32,
    /// From a command to its first effect on a motor, s, 0 to 0.2. A NAO's is 30 ms (B-Human 2015).
    pub dead_time: f32,
    /// How old what the body's sensors tell is, s, 0 to 0.2. Together with the dead time 36 ms go from a command to its first
    /// trace in the sensors (B-Human 2023); so 6 ms are left for this.
    pub sensor_delay: f32,
    /// A factor on the noise of all sensors but the cameras, 0 to 100. At 1 it is a NAO's (B-Human 2023); 0 is none.
    pub noise: f32,
    /// Whether the cameras take images; a world without is faster, and needs nothing to draw with.
    pub cameras: bool,
}

/// A part of the robot that may break. For trials.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fault {
    /// The gyroscope: it says that nothing turns.
    Gyroscope,
    /// The pressure sensors of a sole: they say that nothing presses.
    SoleSensors(Side),
    /// A joint's motor: it pulls no more.
    Motor(Joint),
}

impl Default for Physics {
    fn default() -> Self {
        Self {
            friction: 1.0,
            leg_gain: 1.0,
            torque_limit: 5.0,
            dead_time: Nao::DEAD_TIME,
            sensor_delay: 0.006,
            noise: 1.0,
            cameras: true,
        }
    }
}

impl Physics {
    /// # Errors
    ///
    /// If a parameter is out of its range; names it.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let parameters = [
            ("friction", self.friction, (0.05, 3.0)),
            ("leg_gain", self.leg_gain, (0.1, 5.0)),
            ("torque_limit", self.torque_limit, (0.5, 20.0)),
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

    #[test]
    fn the_robot_is_as_slow_as_a_nao() {
        let Physics { dead_time, sensor_delay, noise, .. } = Physics::default();
        // Motors: B-Human 2015, 4.1.1.1. From a command to its trace in the sensors: B-Human 2023, `minDelay`.
        assert_eq!((dead_time, noise), (0.030, 1.0));
        assert!((dead_time + sensor_delay - 0.036).abs() < 1e-6);
    }

    #[test]
    fn a_parameter_out_of_its_range_is_named() {
        assert_eq!(Physics::default().check(), Ok(()));
        for (name, wrong) in [
            ("friction", Physics { friction: f32::NAN, ..Physics::default() }),
            ("torque_limit", Physics { torque_limit: -1.0, ..Physics::default() }),
            ("dead_time", Physics { dead_time: 30.0, ..Physics::default() }),
        ] {
            let error = wrong.check().unwrap_err();
            assert!(error.to_string().contains(name), "{error}");
        }
    }
}
