//! What the motors bear.

use crate::actuator::CONTINUOUS_CURRENT;
use crate::bounds::clamp;
use crate::health::Fault;
use crate::joints::{Joint, Joints};
use crate::robot::Sensors;

/// From the first temperature on a joint is held less firmly, from the second on it is a fault, °C. The robot's own
/// firmware weakens a leg's motor from 76 °C on until it has less than 70 (HULKs 2025 `step_planner.rs`).
const HOT: [f32; 2] = [70.0, 75.0];
/// The same for the heat that goes into a coil, as a multiple of what it bears for good. Our choice: in `MuJoCo` walking
/// brings knees to 2.3, and a motor that pushes with all its force gets past 4 within nine seconds.
const LOADED: [f32; 2] = [3.0, 4.0];
/// A coil has recovered when it has less, on the same scale: what it bears for good.
const RECOVERED: f32 = 1.0;
/// Share of its stiffness that a joint has left at the second value.
const EASED: f32 = 0.7;
/// What a cycle of 10 ms adds to the heat of a coil: one without iron follows within about ten seconds.
const COIL: f32 = 0.001;
/// The most that a current is believed to be, as a multiple of what the motor bears for good.
const MOST: f32 = 10.0;
/// A temperature is believed after this many cycles.
const SURE: u16 = 100;

/// How hot motors and their coils are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MotorLoad {
    /// Heat in each coil, 1: what the motor bears for good.
    loads: Joints,
    /// How much of its stiffness each joint has left.
    shares: Joints,
    /// For how long a joint has been too hot, cycles.
    hot: u16,
    fault: Option<Fault>,
}

impl MotorLoad {
    pub(crate) const fn new() -> Self {
        Self { loads: Joints::all(0.0), shares: Joints::all(1.0), hot: 0, fault: None }
    }

    /// What is too hot, until all have cooled.
    pub(crate) const fn fault(&self) -> Option<Fault> {
        self.fault
    }

    pub(crate) fn derated(&self, stiffness: &Joints) -> Joints {
        let mut eased = *stiffness;
        for (stiffness, share) in eased.0.iter_mut().zip(self.shares.0) {
            *stiffness *= share;
        }
        eased
    }

    /// Takes a cycle's temperatures and currents; what is no number is none. Falling and getting up, brief and hard, do not
    /// count as a load.
    pub(crate) fn step(&mut self, sensors: &Sensors<'_>, upright: bool) {
        let (mut hot, mut overloaded, mut cool) = (None, None, true);
        for joint in Joint::ALL {
            let (temperature, current) = (sensors.temperatures[joint], sensors.currents[joint]);
            let load = &mut self.loads[joint];
            if !upright {
                *load = 0.0;
            } else if !current.is_nan() {
                let share = clamp(current / CONTINUOUS_CURRENT[joint], -MOST, MOST);
                *load += COIL * (share * share - *load);
            }
            cool &= !(temperature >= HOT[0] || *load >= RECOVERED);
            self.shares[joint] = left(temperature, HOT) * left(*load, LOADED);
            if temperature >= HOT[1] {
                hot = Some(Fault::Hot(joint));
            }
            if *load >= LOADED[1] {
                overloaded = Some(Fault::Overloaded(joint));
            }
        }
        self.hot = if hot.is_some() { self.hot.saturating_add(1) } else { 0 };
        let found = hot.filter(|_| self.hot >= SURE).or(overloaded);
        self.fault = self.fault.filter(|_| !cool).or(found);
    }
}

/// How much of its stiffness a joint has left at a value, which may be no number.
fn left(value: f32, [from, to]: [f32; 2]) -> f32 {
    if value > from { 1.0 - (1.0 - EASED) * clamp((value - from) / (to - from), 0.0, 1.0) } else { 1.0 }
}
