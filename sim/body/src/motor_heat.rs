//! Thermal model of the motors.

use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::simulation::SimulatedModel;

use crate::CYCLE_SECONDS;

/// Ambient temperature, and initial temperature of a motor, °C.
const AMBIENT: f32 = 25.0;
/// Steady-state rise above ambient at the continuous current, K. Our estimate: it leads to 85 °C, at which a NAO's firmware has
/// long reduced the stiffness.
const STEADY_RISE: f32 = 60.0;
/// Thermal time constant, s. Our estimate for a motor of 22 mm in a shell: teams report hot knees after a half-time of ten minutes.
const TIME_CONSTANT: f32 = 600.0;

/// Currents and temperatures of all motors. Each motor with its gear is a first-order thermal model: copper loss (current
/// squared) heats it, and it cools in proportion to its rise above ambient.
#[derive(Clone, Debug)]
pub struct MotorHeat {
    temperatures: Joints,
    currents: Joints,
    /// Current at which each motor settles at [`STEADY_RISE`], A.
    continuous: Joints,
}

impl MotorHeat {
    /// Returns motors at ambient temperature.
    #[must_use]
    pub fn new(model: &'static SimulatedModel) -> Self {
        let current =
            |joint| libm::sqrtf(model.thermal_ratings[joint].continuous_loss() / model.actuators[joint].resistance());
        let continuous = Joints(Joint::ALL.map(current));
        Self { temperatures: Joints::all(AMBIENT), currents: Joints::all(0.0), continuous }
    }

    /// Advances by one control cycle in which the motors draw these currents, A.
    pub fn step(&mut self, currents: Joints) {
        self.currents = currents;
        for i in 0..JOINTS {
            let share = currents.0[i] / self.continuous.0[i];
            let steady = AMBIENT + STEADY_RISE * share * share;
            self.temperatures.0[i] += CYCLE_SECONDS / TIME_CONSTANT * (steady - self.temperatures.0[i]);
        }
    }

    /// Sets the temperature of a motor, °C.
    pub fn set(&mut self, joint: Joint, temperature: f32) {
        self.temperatures[joint] = temperature;
    }

    /// Currents in the last cycle, A.
    #[must_use]
    pub const fn currents(&self) -> Joints {
        self.currents
    }

    /// Measured temperatures: rounded down to whole degrees, °C.
    #[must_use]
    pub fn temperatures(&self) -> Joints {
        Joints(self.temperatures.0.map(libm::floorf))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;

    #[test]
    fn high_load_heats_all_motors_of_arm_alike() {
        let mut heat = MotorHeat::new(TEST_MODEL);
        let loaded = Joints(Joint::ALL.map(|joint| TEST_MODEL.actuators[joint].current(1.3)));
        for _ in 0..6000 {
            heat.step(loaded);
        }
        for joint in [Joint::LShoulderPitch, Joint::LShoulderRoll, Joint::RElbowRoll] {
            let warm = heat.temperatures()[joint];
            assert!((35.0..45.0).contains(&warm), "{joint:?}: {warm}");
        }
    }

    #[test]
    fn temperature_approaches_its_steady_rise() {
        let mut heat = MotorHeat::new(TEST_MODEL);
        let minutes = |heat: &mut MotorHeat, minutes: u32, currents: Joints| {
            for _ in 0..6000 * minutes {
                heat.step(currents);
            }
            heat.temperatures()[Joint::LKneePitch]
        };
        let continuous = Joints(Joint::ALL.map(|joint| TEST_MODEL.continuous_current(joint)));
        let after_ten = minutes(&mut heat, 10, continuous);
        assert!((60.0..65.0).contains(&after_ten), "{after_ten}");
        let settled = minutes(&mut heat, 60, continuous);
        assert!((83.0..=85.0).contains(&settled), "{settled}");
        let rested = minutes(&mut heat, 10, Joints::all(0.0));
        assert!((45.0..50.0).contains(&rested), "{rested}");
    }
}
