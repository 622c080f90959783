//! Thermal load of the motors.

use super::Fault;
use crate::bounds::clamp;
use crate::joints::{Joint, Joints};
use crate::model::{Range, RobotModel};
use crate::robot::{Sensors, plausible_temperature};

/// I²t load below which a coil has recovered, relative to the load at the continuous current.
const RECOVERED_LOAD: f32 = 1.0;
/// I²t filter gain per cycle of 10 ms. The time constant of about 10 s is that of a coil without iron.
const LOAD_GAIN: f32 = 0.001;
/// Maximum plausible current, relative to the continuous current.
const MAX_RELATIVE_CURRENT: f32 = 10.0;
/// Number of consecutive cycles with a high temperature after which it is a fault.
const HOT_CYCLES: u16 = 100;

/// Load of all motors, and the derating that follows from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MotorLoad {
    /// I²t load of each coil, relative to the load at the continuous current.
    loads: Joints,
    /// Share of its stiffness that each joint has left, 0 to 1.
    shares: Joints,
    /// Consecutive cycles with a high temperature.
    hot: u16,
    fault: Option<Fault>,
}

impl MotorLoad {
    pub(super) const fn new() -> Self {
        Self { loads: Joints::all(0.0), shares: Joints::all(1.0), hot: 0, fault: None }
    }

    /// Current fault. It ends when all motors have cooled.
    pub(super) const fn fault(&self) -> Option<Fault> {
        self.fault
    }

    /// Stiffness after derating.
    pub(super) fn derated(&self, stiffness: &Joints) -> Joints {
        let mut derated = *stiffness;
        for (stiffness, share) in derated.0.iter_mut().zip(self.shares.0) {
            *stiffness *= share;
        }
        derated
    }

    /// Processes temperatures and currents of one cycle; NaN means unknown. Currents during a fall and a get-up, brief and
    /// high, are not counted.
    pub(super) fn step(&mut self, model: &RobotModel, sensors: &Sensors<'_>, upright: bool) {
        let limits = model.thermal;
        let (mut hot, mut overloaded, mut cool) = (None, None, true);
        for joint in Joint::ALL {
            let temperature = plausible_temperature(sensors.temperatures[joint]);
            let current = sensors.currents[joint];
            let load = &mut self.loads[joint];
            if !upright {
                *load = 0.0;
            } else if !current.is_nan() {
                let relative =
                    clamp(current / model.continuous_current(joint), -MAX_RELATIVE_CURRENT, MAX_RELATIVE_CURRENT);
                *load += LOAD_GAIN * (relative * relative - *load);
            }
            cool &= !(temperature >= limits.temperature.min || *load >= RECOVERED_LOAD);
            self.shares[joint] = share(model, temperature, limits.temperature) * share(model, *load, limits.load);
            if temperature >= limits.temperature.max {
                hot = Some(Fault::Hot(joint));
            }
            if *load >= limits.load.max {
                overloaded = Some(Fault::Overloaded(joint));
            }
        }
        self.hot = if hot.is_some() { self.hot.saturating_add(1) } else { 0 };
        let found = hot.filter(|_| self.hot >= HOT_CYCLES).or(overloaded);
        self.fault = self.fault.filter(|_| !cool).or(found);
    }
}

/// Share of the stiffness that is left at a value; 1 for NaN.
fn share(model: &RobotModel, value: f32, Range { min, max }: Range) -> f32 {
    if value > min {
        1.0 - (1.0 - model.thermal.derated_stiffness) * clamp((value - min) / (max - min), 0.0, 1.0)
    } else {
        1.0
    }
}
